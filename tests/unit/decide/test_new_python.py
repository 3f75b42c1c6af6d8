"""Code that uses what came with a newer Python gets one that has it, where nothing names another."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GUARDED = "try:\n    import tomllib\nexcept ImportError:\n    import tomli as tomllib\n"
STATE = "model.load_state_dict(dict(zip(names, values)), strict=False)\n"


@pytest.mark.parametrize(
    ("code", "python"),
    [
        ("import hashlib\nprint(hashlib.file_digest(open('a', 'rb'), 'md5'))\n", "3.12"),
        ("from tomllib import loads\n", "3.12"),
        ("from enum import Enum, StrEnum\n", "3.12"),
        ("from datetime import datetime, UTC\n", "3.12"),
        ("def f() -> int | None: ...\n", "3.10"),
        ("# hashlib.file_digest(a, b)\n", "3.10"),
        ("from pytz import UTC\nprint(pytz.UTC)\n", "3.10"),
        (GUARDED, "3.10"),
    ],
)
def test_what_a_newer_python_brought(tree: Tree, code: str, python: str) -> None:
    assert tree({"a.py": code, "requirements.txt": "numpy\n"}).python.version == python


@pytest.mark.parametrize(
    ("code", "python"),
    [
        ("import os\n", "3.8"),
        ("def f(a: list[int]) -> None: ...\n", "3.9"),
        ("async def f(a: Optional[dict[str, int]] = None): ...\n", "3.9"),
        ("from __future__ import annotations\ndef f(a: list[int]) -> None: ...\n", "3.8"),
        ("def f(a: 'list[int]'):\n    b: list[int] = []\n", "3.8"),
        ("def f(a: List[int], b=list[0]): ...\n", "3.8"),
        ("name = name.removesuffix('.py')\n", "3.9"),
        ("frame.name.str.removesuffix('.py')\n", "3.8"),
        ("from functools import lru_cache\n", "3.8"),
        ("from functools import cache, partial\n", "3.9"),
        (STATE, "3.8"),
        ("def f(flags: int = re.I | re.M): ...\n", "3.8"),
    ],
)
def test_of_the_pythons_that_fit_the_pins_one_that_reads_the_code(tree: Tree, code: str, python: str) -> None:
    assert tree({"a.py": code, "requirements.txt": "numpy==1.19.3\n"}).python.version == python


@pytest.mark.parametrize("line", ["zip(a, b, strict=True)", "zip(a.items(), f(b), strict = False)"])
def test_zip_with_strict_is_of_python_3_10(tree: Tree, line: str) -> None:
    project = "[project]\nname = 'a'\nversion = '1'\nrequires-python = '>=3.8,!=3.10.*'\n"
    assert tree({"a.py": f"for each in {line}:\n    pass\n", "pyproject.toml": project}).python.version == "3.12"


def test_an_environment_that_names_one_is_made(tree: Tree) -> None:
    made = "name: a\ndependencies:\n  - python=3.9\n  - numpy\n"
    files = {"a.py": "import hashlib\nhashlib.file_digest(a, 'md5')\n", "environment.yml": made}
    assert tree(files).python.version == "3.9"


def test_a_script_beside_cpp_changes_no_ubuntu(tree: Tree) -> None:
    cmake = "cmake_minimum_required(VERSION 3.10)\nproject(a CXX)\nadd_executable(a a.cpp)\n"
    files = {"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "tools/pack.py": "import tomllib\nimport numpy\n"}
    found = tree(files)
    assert (found.kind, found.ubuntu) == ("cpp", "jammy")


def test_nodes_keep_the_distribution_that_is_named(tree: Tree) -> None:
    files = {
        "package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\n",
        "README.md": "ROS Noetic\n",
        "nodes/node.py": "import rospy\ndef f(a: int | None): ...\n",
    }
    assert tree(files).ros_distro == "noetic"
