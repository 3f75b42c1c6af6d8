"""A setup.py that compiles with CMake."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = """from setuptools import Extension, setup
class CMakeExtension(Extension): pass
setup(name="demo", ext_modules=[CMakeExtension("demo")], install_requires=["numpy"])
"""
PROJECT = '[project]\nname = "demo"\nversion = "1"\n'


@pytest.mark.parametrize(
    ("more", "asked"),
    [
        ({}, ["cmake<4"]),
        ({"requirements.txt": "cmake==3.18.4\n"}, ["cmake==3.18.4"]),
        ({"pyproject.toml": '[build-system]\nrequires = ["setuptools", "pybind11"]\n' + PROJECT}, ["cmake<4"]),
        ({"pyproject.toml": '[build-system]\nrequires = ["setuptools", "cmake>=3.12"]\n'}, []),
        ({"pyproject.toml": '[build-system]\nrequires = ["scikit-build-core"]\n' + PROJECT}, []),
        ({"setup.py": SETUP.replace("CMake", "Other")}, []),
    ],
)
def test_cmake_is_there_before_a_setup_script_calls_it(tree: Tree, more: dict[str, str], asked: list[str]) -> None:
    files = {"setup.py": SETUP, "demo/__init__.py": "import numpy\n", "demo/a.py": "import numpy\n"}
    assert [each.text for each in tree(files | more).python.first if each.key == "cmake"] == asked


def test_the_cmake_of_a_base_of_ros_is_taken(tree: Tree) -> None:
    xml = "<package><name>nodes</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {
        "nodes/package.xml": xml,
        "nodes/CMakeLists.txt": "find_package(catkin REQUIRED)\n",
        "demo/setup.py": SETUP,
    }
    files["README.md"] = "```\nroslaunch nodes a.launch\ncd demo && pip install .\n```\n"
    found = tree(files)
    assert (found.kind, found.python.projects) == ("ros1", ("demo",))
    assert all(each.key != "cmake" for each in found.python.first)


@pytest.mark.parametrize(("given", "copied"), [(", disable_editable=True", (".",)), ("", ())])
def test_what_is_not_compiled_for_an_editable_installation_is_copied(
    tree: Tree, given: str, copied: tuple[str, ...]
) -> None:
    script = SETUP.replace('("demo")', f'("demo"{given})')
    assert script != SETUP or not given
    decision = tree({"setup.py": script, "demo/__init__.py": "import numpy\n"})
    assert decision.compiling.copied == copied


@pytest.mark.parametrize(
    ("lines", "asked"),
    [
        ("MulticoreTSNE\n", ["cmake<4"]),
        ("cmake\nMulticoreTSNE\n", ["cmake<4"]),
        ("cmake==3.18.4\nMulticoreTSNE\n", ["cmake==3.18.4"]),
        ("cmake>=4\nMulticoreTSNE\n", ["cmake>=4"]),
        ("cmake\nunknown-and-built\n", ["cmake"]),
        ("cmake\nabsl-py\n", []),
        ("absl-py\n", []),
    ],
)
def test_cmake_is_there_before_what_is_listed_beside_it(tree: Tree, lines: str, asked: list[str]) -> None:
    found = tree({"requirements.txt": lines, "main.py": "print('x')\n"}).python.first
    assert [each.text for each in found if each.key == "cmake"] == asked
