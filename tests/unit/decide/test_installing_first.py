"""A script of any name that installs what it starts, and that a page has its reader run."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
START = "#!/bin/bash\nsudo apt-get install screen -y\npip3 install console-menu\npython3 menu.py\n"
REST = {"requirements.txt": "numpy\n"}
MENU = "import consolemenu\nif __name__ == '__main__':\n    consolemenu.show()\n"


@pytest.mark.parametrize(
    ("page", "script", "read"),
    [
        ("```\n./start.sh\n```\n", "start.sh", True),
        ("Run `bash start.sh`.\n", "start.sh", True),
        ("```\n./restart.sh\n```\n", "start.sh", False),
        ("```\npython3 menu.py\n```\n", "start.sh", False),
        ("```\n./bin/start.sh\n```\n", "bin/start.sh", False),
    ],
)
def test_its_packages_are_the_images(tree: Tree, page: str, script: str, *, read: bool) -> None:
    decision = tree({"README.md": f"# Menu\n\n{page}", script: START, "menu.py": MENU})
    assert ("screen" in {*decision.apt, *decision.apt_guessed}) is read


def test_one_that_installs_nothing_is_none(tree: Tree) -> None:
    script = "echo pip install console-menu\npython3 menu.py\n"
    decision = tree({"README.md": "```\n./start.sh\n```\n", "start.sh": script, "menu.py": "print(1)\n", **REST})
    assert not decision.apt_guessed
