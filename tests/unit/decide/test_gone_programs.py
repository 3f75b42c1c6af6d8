"""A page runs a program that the tree no longer has: the image starts a shell, and says so."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "import numpy\nif __name__ == '__main__':\n    pass\n"
FILES = {"scripts/one/a.py": MAIN, "scripts/one/b.py": MAIN}


@pytest.mark.parametrize(
    ("called", "told"),
    [
        ("scripts/two/01-train.py --fast", True),
        ("./scripts/old.py", True),
        ("other/train.py", False),  # of another repository
        ("train.py", False),
        ("scripts/your_script.py", False),
        ("one/a.py", False),
    ],
)
def test_it_is_told(tree: Tree, called: str, told: bool) -> None:
    decision = tree({**FILES, "README.md": f"# Demo\n## Usage\n```\npython {called}\n```\n"})
    found = [each for each in decision.warnings if "which the tree does not have" in each.message]
    assert bool(found) is told
    assert not told or (decision.command == ("bash",) and found[0].line == 4)


def test_where_the_page_runs_another_one_it_is_the_command(tree: Tree) -> None:
    page = "# Demo\n## Usage\n```\npython scripts/two/train.py\npython scripts/one/a.py\n```\n"
    decision = tree({**FILES, "README.md": page})
    assert decision.command == ("python", "scripts/one/a.py")
    assert not [each for each in decision.warnings if "which the tree does not have" in each.message]
