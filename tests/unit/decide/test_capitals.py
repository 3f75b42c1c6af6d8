"""Programs that a page spells with other capitals than the tree."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = "if __name__ == '__main__':\n    print('a')\n"


@pytest.mark.parametrize(
    ("line", "files", "command"),
    [
        ("python PLAN/train.py", {"Plan/train.py": MAIN}, ("python", "Plan/train.py")),
        ("python plan/Train.py --fast", {"Plan/train.py": MAIN}, ("python", "Plan/train.py", "--fast")),
        ("bash Run.sh", {"run.sh": "python train.py\n", "train.py": MAIN}, ("bash", "run.sh")),
        ("python PLAN/train.py", {"Plan/train.py": MAIN, "PLAN/train.py": MAIN}, ("python", "PLAN/train.py")),
        ("python PLAN/train.py", {"Plan/train.py": MAIN, "plan/train.py": MAIN}, ("bash",)),
    ],
)
def test_the_command_has_the_path_of_the_tree(
    tree: Tree, line: str, files: dict[str, str], command: tuple[str, ...]
) -> None:
    page = f"# A\n## Usage\n```\n{line}\n```\n"
    assert tree({**files, "requirements.txt": "numpy\n", "README.md": page}).command == command
