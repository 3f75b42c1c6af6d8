"""Lists of requirements that a page has pip read, whatever their names."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("command", "read"),
    [
        ("pip install -r python_dependencies.txt", True),
        ("cd ~/ws/src/demo\npip3 install --requirement python_dependencies.txt", True),
        ("pip install -r other.txt", False),
        ("cat python_dependencies.txt", False),
    ],
)
def test_a_list_of_any_name_that_a_page_gives_pip(tree: Tree, command: str, read: bool) -> None:
    files = {"python_dependencies.txt": "einops==0.3.0\n", "requirements.txt": "numpy\n", "main.py": "import time\n"}
    python = tree({**files, "README.md": f"# Demo\n```\n{command}\n```\n"}).python
    assert ("python_dependencies.txt" in python.requirements) is read
