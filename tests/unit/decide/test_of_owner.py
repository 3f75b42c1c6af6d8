"""What a project needs and only its owner has comes from the owner's repository that a page links to."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Arm\n\nIt needs [arm-np-tools](https://github.com/lab/arm-np-tools).\n"
SETUP = "from setuptools import setup\nsetup(name='arm_envs', version='1', install_requires=['{}', 'numpy'])\n"
FILES = {
    "README.md": PAGE,
    "setup.py": SETUP.format("arm_np_tools"),
    "arm_envs/__init__.py": "import arm_np_tools\n",
    ".git/config": '[remote "origin"]\n\turl = git@github.com:lab/arm-envs.git\n',
}
FROM_GIT = "git+https://github.com/lab/arm-np-tools"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({}, [FROM_GIT]),
        ({"README.md": f"{PAGE}\n```\npip install -e .\n```\n"}, [FROM_GIT]),
        ({"README.md": PAGE.replace("tools)", "tools/tree/v2)")}, [f"{FROM_GIT}@v2"]),
        ({"README.md": PAGE.replace("com/lab", "com/other")}, []),
        ({"README.md": "# Arm\n", "docs/a.md": PAGE}, []),
        ({"setup.py": SETUP.format("arm_np_tools==1.0")}, []),  # it was released
        ({"setup.py": SETUP.format("arm_np_tools<2")}, []),
        ({"setup.py": SETUP.format("arm_np_tools>=0.1")}, []),
        ({"setup.py": SETUP.format("arm_np_tools @ git+https://github.com/lab/arm-np-tools@v1")}, []),
        ({"setup.py": SETUP.format("arm-tools"), "arm_envs/__init__.py": ""}, []),
        (
            {
                "README.md": PAGE.replace("arm-np-tools", "scipy"),
                "setup.py": SETUP.format("scipy"),
                "arm_envs/__init__.py": "import scipy\n",
            },
            [],
        ),
        ({".git/config": FILES[".git/config"].replace("arm-envs", "arm-np-tools")}, []),  # it is the repository itself
        ({".git/config": ""}, []),
    ],
)
def test_its_repository_comes_before_the_project(tree: Tree, files: dict[str, str], found: list[str]) -> None:
    guessed = [asked.written for asked in tree(FILES | files).python.pip_guessed]
    assert [each for each in guessed if each.startswith("git+")] == found
