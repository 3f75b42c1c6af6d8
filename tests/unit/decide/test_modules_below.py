"""A module that a page starts by a dotted name, below a folder that nothing installs: Python is told the folder."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

MAIN = 'import numpy\n\n\ndef main(): ...\n\n\nif __name__ == "__main__":\n    main()\n'
FILES = {
    "README.md": "# x\n\n## Run\n\n* After installing, run `python -m walk.control`\n",
    "requirements.txt": "numpy\n",
    "python/walk/__init__.py": "",
    "python/walk/control.py": MAIN,
}


def test_such_a_module_is_the_command_and_is_found(tree: Tree) -> None:
    decision = tree(FILES)
    assert decision.command == ("python", "-m", "walk.control")
    assert decision.python_path == ("python",)


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"setup.py": "from setuptools import setup\nsetup(name='walk', package_dir={'': 'python'})\n"}, True),
        ({"walk/control.py": MAIN, "walk/__init__.py": ""}, True),  # the root comes first
        ({"other/walk/control.py": MAIN, "other/walk/__init__.py": ""}, False),
        ({"README.md": "# x\n\n```\npython -m control\n```\n"}, False),
    ],
)
def test_elsewhere_no_folder_is_told(tree: Tree, files: dict[str, str], *, found: bool) -> None:
    decision = tree({**FILES, **files})
    assert (decision.command == ("python", "-m", "walk.control")) is found
    assert not decision.python_path
