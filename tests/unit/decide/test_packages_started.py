"""A package with a __main__.py is started by its name, which alone lets it import what lies beside it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = "[project]\nname = 'walk'\nversion = '1'\ndependencies = ['numpy']\n"
PARTS = {"requirements.txt": "numpy\n", "walk/track.py": "import numpy\ndef run():\n    pass\n"}
RELATIVE = "from .track import run\nrun()\n"


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({"walk/__main__.py": RELATIVE}, "python3 -m walk"),
        ({"walk/__main__.py": "from walk.track import run\nrun()\n"}, "python3 -m walk"),
        ({"walk/__main__.py": "import numpy\nprint(1)\n", "walk/__init__.py": ""}, "python3 -m walk"),
        ({"walk/__main__.py": "from track import run\nrun()\n"}, "python3 walk/__main__.py"),
        ({"walk/__main__.py": "from track import run\nrun()\n", "walk/__init__.py": ""}, "python3 walk/__main__.py"),
        ({"my-walk/__main__.py": "import numpy\nprint(1)\n"}, "python3 my-walk/__main__.py"),
        ({"src/walk/__init__.py": "", "src/walk/__main__.py": RELATIVE, "pyproject.toml": PROJECT}, "python3 -m walk"),
        ({"src/walk/__init__.py": "", "src/walk/__main__.py": RELATIVE}, "bash"),
        ({"walk/__init__.py": "", "walk/more/__init__.py": "", "walk/more/__main__.py": RELATIVE}, "bash"),
    ],
)
def test_the_call_of_a_package(tree: Tree, files: dict[str, str], command: str) -> None:
    assert " ".join(tree({**PARTS, **files}).command) == command


def test_what_is_installed_with_it_comes_first(tree: Tree) -> None:
    project = f"{PROJECT}[project.scripts]\nwalk-track = 'walk.track:run'\n"
    found = tree({**PARTS, "walk/__init__.py": "", "walk/__main__.py": RELATIVE, "pyproject.toml": project})
    assert (found.command, found.command_candidates[1]) == (("walk-track",), ("python3", "-m", "walk"))
