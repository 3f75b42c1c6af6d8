"""Two calls of one program in one section, of which the first names a file that nothing brings."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FIRST = "python flow.py --cfg cfg/a.json --path models/a.pth"
SECOND = "python flow.py --cfg cfg/a.json --url lab/a"


def command(tree: Tree, page: str) -> str:
    files = {"flow.py": "import numpy\n", "cfg/a.json": "{}", "requirements.txt": "numpy\n"}
    return " ".join(tree({**files, "README.md": page}).command)


@pytest.mark.parametrize("second", [SECOND, "python flow.py --cfg cfg/a.json", f"python flow.py --fast {SECOND[15:]}"])
def test_the_call_that_needs_none_is_taken(tree: Tree, second: str) -> None:
    assert command(tree, f"# Use\n```\n{FIRST}\n```\nor\n```\n{second}\n```\n") == second


@pytest.mark.parametrize(
    "page",
    [
        f"# Use\n```\n{FIRST}\npython flow.py --url lab/a\n```\n",  # it leaves out more
        f"# Use\n```\n{FIRST}\n```\n# More\n```\n{SECOND}\n```\n",
        f"# Use\n```\n{FIRST}\npython flow.py --cfg cfg/a.json --path models/b.pth\n```\n",
        f"# Use\n```\nwget https://lab.org/a.pth -O models/a.pth\n{FIRST}\n{SECOND}\n```\n",
    ],
)
def test_the_first_is_kept_where_the_other_is_for_something_else(tree: Tree, page: str) -> None:
    assert command(tree, page) == FIRST


@pytest.mark.parametrize("given", ["--output out/a.png", "--save=a.mp4", "--films films/*.mp4", "--name a.b"])
def test_what_it_writes_or_a_shell_fills_in_is_not_missing(tree: Tree, given: str) -> None:
    first = f"python flow.py --cfg cfg/a.json {given}"
    assert command(tree, f"# Use\n```\n{first}\n{SECOND}\n```\n") == first
