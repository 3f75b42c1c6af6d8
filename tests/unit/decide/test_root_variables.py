"""Variables below which files of the tree are named: the repository's own folder."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = "from setuptools import setup\nsetup(name='walker')\n"
FILES = {"README.md": "# Walker\n", "engine/maps/hall.yaml": "a: 1\n", "src/core/a.hpp": "\n"}


def _set(found: Decision) -> dict[str, str]:
    return dict(found.variables)


@pytest.mark.parametrize(
    ("line", "there"),
    [
        ('maps = os.environ["WALKER_PATH"] + "/engine/maps/"', True),
        ('maps = os.environ["WALKER_PATH"] + \\\n    "/engine/maps/hall.yaml"', True),
        ('maps = os.path.join(os.environ["WALKER_PATH"], "engine", "maps")', True),
        ('maps = os.path.join(os.getenv("WALKER_PATH"), "engine/maps/hall.yaml")', True),
        ('maps = Path(os.environ["WALKER_PATH"]).joinpath("engine/maps")', True),
        ('maps = Path(os.environ["WALKER_PATH"]) / "engine" / "maps"', True),
        ('maps = os.environ["WALKER_PATH"] + "/engine"', True),
        ('code = os.environ["WALKER_PATH"] + "/src/core"', True),
        # the second argument of a function that does not join
        ('maps = load(os.environ["WALKER_PATH"], "engine/maps")', False),
        # not in the tree, or a folder that many have
        ('maps = os.environ["WALKER_PATH"] + "/engine/grids"', False),
        ('code = os.environ["WALKER_PATH"] + "/src"', False),
        # a default, and a variable that the program sets
        ('maps = os.environ.get("WALKER_PATH", "engine/maps")', False),
        ('os.environ["WALKER_PATH"] = here\nmaps = os.environ["WALKER_PATH"] + "/engine/maps"', False),
        ('maps = os.environ["HOME"] + "/engine/maps"', False),
    ],
)
def test_a_variable_of_programs(tree: Tree, line: str, *, there: bool) -> None:
    code = f"import os\nfrom pathlib import Path\nimport numpy\n{line}\n"
    found = _set(tree({**FILES, "setup.py": SETUP, "run.py": code}))
    assert found == ({"WALKER_PATH": "./"} if there else {})


@pytest.mark.parametrize(
    ("name", "below", "there"),
    [
        ("WALKER_PATH", "engine/maps", True),
        ("WALKER_PATH", "engine/grids", False),
        ("SDK_DIR", "include/sdk", False),
        ("ROS_ROOT", "engine/maps", False),
    ],
)
def test_a_variable_of_cmake(tree: Tree, name: str, below: str, *, there: bool) -> None:
    cmake = f"project(Walker)\ninclude_directories($ENV{{{name}}}/{below})\nadd_executable(walker walker.cpp)\n"
    files = {**FILES, "include/sdk/sdk.h": "\n", "CMakeLists.txt": cmake, "walker.cpp": "int main() {}\n"}
    assert _set(tree(files)) == ({name: "./"} if there else {})


def test_a_variable_of_cpp(tree: Tree) -> None:
    code = '#include <cstdlib>\n#include <string>\nint main() {\n  auto a = getenv("WALKER_PATH") +\n    %s;\n}\n'
    cmake = "project(Walker)\nadd_executable(walker walker.cpp)\n"
    text = code % 'std::string(\n      "/engine/maps/hall.yaml")'
    found = tree({**FILES, "CMakeLists.txt": cmake, "walker.cpp": text})
    assert _set(found) == {"WALKER_PATH": "./"}
    why = [each.reason for each in found.reasons if each.answer == "WALKER_PATH=./"]
    assert why == ["the tree names its own engine/maps/hall.yaml below it"]


def test_the_place_that_a_page_gives_wins(tree: Tree) -> None:
    page = "# Walker\n```\nexport WALKER_ROOT=$(pwd)/engine\n```\n"
    code = "import os\nimport numpy\nmaps = os.environ['WALKER_ROOT'] + '/engine/maps'\n"
    assert _set(tree({**FILES, "README.md": page, "run.py": code}))["WALKER_ROOT"] == "./engine"
