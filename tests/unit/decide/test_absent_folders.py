"""Folders that CMake adds in any case and that the tree does not have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hanging import ends
from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TOP = "cmake_minimum_required(VERSION 3.10)\nproject(demo CXX)\n"
CODE = {"lib/CMakeLists.txt": "add_library(demo demo.cpp)\n", "lib/demo.cpp": "int a;\n"}
MODULE = '[submodule "third/utils"]\npath = third/utils\nurl = https://a.b/c/utils\n'
EACH = "foreach(part lib utils)\n  add_subdirectory(${part})\nendforeach()\n"


def told(decision: Decision) -> list[tuple[str, str]]:
    """Return the folders and the ends of the warnings."""
    said = [w.message for w in decision.warnings if "which the tree does not have" in w.message]
    return [(each.split()[2].rstrip(","), each.partition(": ")[2].partition(";")[0]) for each in said]


@pytest.mark.parametrize(
    ("lines", "files", "absent"),
    [
        ("add_subdirectory(lib)\nadd_subdirectory(utils)\n", {}, "utils"),
        (EACH, {}, "utils"),
        ("add_subdirectory(lib)\nif(WITH_UTILS)\n  add_subdirectory(utils)\nendif()\n", {}, ""),
        ("add_subdirectory(lib)\nadd_subdirectory(../utils)\n", {}, ""),
        ("add_subdirectory(lib)\nexecute_process(COMMAND fetch.sh)\nadd_subdirectory(utils)\n", {}, ""),
        ("add_subdirectory(lib)\nadd_subdirectory(utils)\n", {"get.sh": "git clone https://a.b/c/utils\n"}, ""),
        ("add_subdirectory(lib)\nadd_subdirectory(utils)\n", {".gitmodules": '[submodule "utils"]\n'}, ""),
        (
            "add_subdirectory(lib)\nadd_subdirectory(utils)\n",
            {**{f"a/b/{number}.txt": "a" for number in range(250)}, "get.sh": "git clone https://a.b/c/utils\n"},
            "",
        ),
        ("add_subdirectory(lib)\nadd_subdirectory(${CMAKE_BINARY_DIR}/utils)\n", {}, ""),
        ("add_subdirectory(lib)\nadd_subdirectory(third/utils/src)\n", {}, "third/utils/src"),
        ("add_subdirectory(lib)\nadd_subdirectory(third/utils/src)\n", {".gitmodules": MODULE}, ""),
        (
            "add_subdirectory(lib)\nadd_subdirectory(third/utils/src)\n",
            {"get.sh": "git clone https://a.b/c/utils\n"},
            "",
        ),
        ("add_subdirectory(lib)\nadd_subdirectory(lib/src)\n", {".gitmodules": MODULE}, "lib/src"),
    ],
)
def test_a_folder_that_is_not_there(tree: Tree, lines: str, files: dict[str, str], absent: str) -> None:
    found = tree({**CODE, "CMakeLists.txt": TOP + lines, **files})
    assert found.kind == "cpp"
    assert told(found) == ([(absent, "cmake will stop")] if absent else [])


@pytest.mark.parametrize(("lines", "kind"), [(EACH, "python"), ("add_subdirectory(lib)\n", "cpp")])
def test_what_is_python_beside_it_is_no_program_of_cpp(tree: Tree, lines: str, kind: str) -> None:
    python = {
        "py/setup.py": "from setuptools import setup\nsetup(name='demo', packages=['demo'])\n",
        "py/demo/__init__.py": "import numpy\n",
        "py/run.py": "import demo\n",
        "README.md": "# Demo\n```\npip install -e .\npython py/run.py\n```\n",
    }
    found = tree({**CODE, "CMakeLists.txt": TOP + lines, **python})
    assert found.kind == kind
    assert found.python.projects == ("py",)
    assert told(found) == ([("utils", "nothing is compiled")] if kind == "python" else [])


def test_a_package_that_adds_one_is_left_out(tree: Tree) -> None:
    xml = "<package format='2'><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
    lines = TOP + "find_package(catkin REQUIRED)\ncatkin_package()\nadd_subdirectory({})\n"
    files = {
        "good/package.xml": xml.format("good"),
        "good/CMakeLists.txt": lines.format("lib"),
        "good/lib/CMakeLists.txt": "add_library(good a.cpp)\n",
        "good/lib/a.cpp": "int a;\n",
        "bad/package.xml": xml.format("bad"),
        "bad/CMakeLists.txt": lines.format("utils"),
    }
    found = tree({**files, "README.md": "# Demo\nROS Noetic\n"})
    assert told(found) == [("bad/utils", "bad is left out of the build")]


def test_many_of_them_take_no_long_time(tree: Tree) -> None:
    names = [f"part{number}" for number in range(4_000)]
    page = "git clone https://a.b/c\n" + " ".join(names)
    files = {f"docs/{number}.md": page for number in range(150)}
    with ends():
        found = tree(
            {**CODE, "CMakeLists.txt": TOP + "".join(f"add_subdirectory({each})\n" for each in names), **files}
        )
    assert not told(found)
