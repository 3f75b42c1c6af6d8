"""The folder in which a program has to be started, by what it puts on Python's path."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GUARD = "if __name__ == '__main__':\n    main()\n"


@pytest.mark.parametrize(
    ("added", "more", "command"),
    [
        ("sys.path.append('parts')", {}, "cd src && exec python3 main.py"),
        ('sys.path.insert(0, "parts/")', {}, "cd src && exec python3 main.py"),
        ("sys.path.append('parts')", {"parts/arm.py": ""}, ("python3", "src/main.py")),
        ("sys.path.append('src/parts')", {}, ("python3", "src/main.py")),
        ("sys.path.append(os.path.join(HERE, 'parts'))", {}, ("python3", "src/main.py")),
        ("sys.path.append('others')", {}, ("python3", "src/main.py")),
    ],
)
def test_a_program_is_started_where_its_path_leads(
    tree: Tree, added: str, more: dict[str, str], command: tuple[str, ...] | str
) -> None:
    program = {"src/main.py": f"import sys\n{added}\nimport leg\n{GUARD}", "src/parts/leg.py": ""}
    assert tree({**program, **more}).command == command


def test_a_page_says_where_it_is_started(tree: Tree) -> None:
    program = {"src/main.py": f"import sys\nsys.path.append('parts')\n{GUARD}", "src/parts/leg.py": ""}
    page = {"README.md": "```\npython src/main.py --fast\n```\n"}
    assert tree({**program, **page}).command == ("python", "src/main.py", "--fast")


@pytest.mark.parametrize(
    ("line", "inside"),
    [
        ("sys.path.insert(1, os.getcwd() + '/..')", True),
        ("sys.path.append('..')", True),
        ("sys.path.append(os.path.join(os.getcwd(), '../lib'))", True),
        ("sys.path.append(os.path.abspath('../lib'))", True),
        ("sys.path.append(os.path.join(os.path.dirname(__file__), '..'))", False),
        ("sys.path.append(os.getcwd() + '/lib')", False),
        ("net = open('../lib/net.py')", True),
        ("parser.add_argument('--net', default='../lib/net.py')", True),
        ("net = open('../lib/other.py')", False),
        ("# net = open('../lib/net.py')", False),
        ("net = open(os.path.join(HERE, '../lib/net.py'))", False),
    ],
)
def test_a_program_is_started_below_what_it_reads(tree: Tree, line: str, inside: bool) -> None:
    found = tree({"src/main.py": f"import os\nimport sys\n{line}\n{GUARD}", "lib/net.py": "", "net.py": ""})
    assert found.command == ("cd src && exec python3 main.py" if inside else ("python3", "src/main.py"))
