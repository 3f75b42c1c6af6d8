"""Programs that import a package of the folder that a page goes to, or of one above their own."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = "{}\nif __name__ == '__main__':\n    main()\n"
PAGE = "# Track\n## Run\n```\ncd tracker\npython tools/run.py\n```\n"
TRACKER = {
    "README.md": PAGE,
    "requirements.txt": "numpy\n",
    "tracker/tools/run.py": PROGRAM.format("from net.core.model import Model"),
    "tracker/net/core/model.py": "import numpy\n",
}


@pytest.mark.parametrize(
    ("more", "folders"),
    [
        ({}, ("tracker",)),
        ({"tracker/net/__init__.py": "", "tracker/net/core/__init__.py": ""}, ("tracker",)),
        ({"README.md": "## Run\n```\npython tracker/tools/run.py\n```\n"}, ("tracker",)),
        (
            {
                "tracker/a/b/run.py": PROGRAM.format("from net import core"),
                "README.md": "```\npython tracker/a/b/run.py\n```\n",
            },
            ("tracker",),
        ),
    ],
)
def test_the_folder_is_on_the_path(tree: Tree, more: dict[str, str], folders: tuple[str, ...]) -> None:
    assert tree({**TRACKER, **more}).python_path == folders


@pytest.mark.parametrize(
    "more",
    [
        {"tracker/tools/net/core/model.py": ""},
        {"tracker/setup.py": "from setuptools import setup\nsetup(name='track', packages=['net'])\n"},
        {"tracker/torch/__init__.py": ""},
        {"tracker/rarely/__init__.py": "", "requirements.txt": "rarely\n"},
        {"tracker/tools/run.py": PROGRAM.format("import sys\nsys.path.append('.')\nfrom net.core.model import Model")},
        {"tracker/tools/run.py": PROGRAM.format("from net.other import Model")},
        {"tracker/tools/run.py": PROGRAM.format("import numpy")},
    ],
)
def test_where_it_is_found_or_would_hide_another(tree: Tree, more: dict[str, str]) -> None:
    assert tree({**TRACKER, **more}).python_path == ()


def test_of_two_packages_of_one_name_that_of_the_default_command(tree: Tree) -> None:
    page = "## Run\n```\ncd other\npython tools/show.py --cfg cfg/a.yaml\ncd ../tracker\npython tools/run.py\n```\n"
    other = {"other/tools/show.py": PROGRAM.format("from net.core import model"), "other/net/core/model.py": ""}
    decision = tree({**TRACKER, **other, "other/cfg/a.yaml": "", "README.md": page})
    assert decision.command == "cd other && exec python tools/show.py --cfg cfg/a.yaml"
    assert decision.python_path == ("other",)
