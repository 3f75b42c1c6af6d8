"""Calls that prepare a program or look after it are no default where the page runs the program otherwise too."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "if __name__ == '__main__':\n    pass\n"


@pytest.mark.parametrize(
    ("lines", "command", "told"),
    [
        (("-m lab assets install", "-m lab doctor", "-m lab app"), "-m lab app", 1),
        (("-m lab doctor", "-m lab run one --fast"), "-m lab run one --fast", 0),
        (("-m lab init", "-m lab"), "-m lab", 1),
        (("-m lab init demo", "-m lab show"), "-m lab show", 1),
        (("-m lab assets install", "main.py"), "-m lab assets install", 0),  # nothing else of it is run
        (("-m lab show", "-m lab verify"), "-m lab show", 0),
        (("-m lab run --list", "-m lab show"), "-m lab run --list", 0),  # an option of its own
        (("main.py check engine", "main.py"), "main.py check engine", 0),  # data of a file of Python
        (("main.py setup", "main.py run fast"), "main.py run fast", 1),
    ],
)
def test_the_other_call_is_meant(tree: Tree, lines: tuple[str, ...], command: str, told: int) -> None:
    page = "".join(f"python {line}\n" for line in lines)
    files = {"lab/__init__.py": "", "lab/__main__.py": "import numpy\n", "main.py": f"import numpy\n{MAIN}"}
    found = tree({**files, "requirements.txt": "numpy\n", "README.md": f"# Lab\n## Run\n```\n{page}```\n"})
    assert found.command == ("python", *command.split())
    said = [each for each in found.warnings if "before the default command" in each.message]
    assert [(each.file, each.line) for each in said] == [("README.md", 4)] * told


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (("tools/generate_paths.py", "train.py"), 4),
        (("tools/preprocess.py --all", "train.py --fast"), 4),
        (("other.py", "tools/generate_paths.py", "train.py"), 0),  # the first of them is the command
        (("tools/create_env.py", "train.py"), 0),
        (("tools/generate_paths.py",), 0),
        (("train.py", "tools/generate_paths.py"), 0),
    ],
)
def test_what_a_section_runs_to_make_something_first(tree: Tree, lines: tuple[str, ...], told: int) -> None:
    page = "".join(f"python {line}\n" for line in lines)
    programs = ("tools/generate_paths.py", "tools/preprocess.py", "tools/create_env.py", "other.py", "train.py")
    files = dict.fromkeys(programs, f"import numpy\n{MAIN}")
    found = tree({**files, "requirements.txt": "numpy\n", "README.md": f"# Lab\n## Train\n```\n{page}```\n"})
    said = [each.line for each in found.warnings if "before the default command" in each.message]
    assert said == [told] * bool(told)
