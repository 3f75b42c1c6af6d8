"""A setup.py that links what CMake compiles beside it stops pip: the project is imported from its folder instead."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import Extension, setup\n"
    "FLAGS = ['-Lbuild', '-lplan']\n"
    "setup(name='planner', ext_modules=[Extension('planner', ['a.cpp'], extra_link_args=FLAGS)]{})\n"
)
LISTS = "cmake_minimum_required(VERSION 3.10)\nproject(planner CXX)\nset(CMAKE_CXX_FLAGS -march=native)\n"
BUILD = "sudo apt-get install -y libeigen3-dev cmake\nmkdir -p build\ncd build\ncmake ..\nmake\n"
FILES = {
    "a.cpp": "int a;\n",
    "plan.cpp": "int b;\n",
    "build.sh": BUILD,
    "run.py": "import ctypes\nif __name__ == '__main__':\n    print('a')\n",
    "README.md": "```\n./build.sh\n```\n\n```\npython3 run.py\n```\n",
}


@pytest.mark.parametrize(
    ("made", "rest", "stopped"),
    [
        ("add_library(plan STATIC plan.cpp)\n", "", True),
        ("add_library(plan STATIC plan.cpp)\n", ", cmdclass={'build_ext': by_cmake}", False),
        ("add_library(other plan.cpp)\n", "", False),
    ],
)
def test_pip_is_not_given_what_it_cannot_link(tree: Tree, made: str, rest: str, *, stopped: bool) -> None:
    decision = tree({**FILES, "setup.py": SETUP.format(rest), "CMakeLists.txt": LISTS + made})
    assert (decision.python.projects == ()) == stopped
    told = [each.message for each in decision.warnings if "setup.py links plan" in each.message]
    assert len(told) == stopped
    assert decision.command == ("python3", "run.py")
    assert [script.path for script in decision.scripts] == ["build.sh"]
    native = [each.message for each in decision.warnings if "-march=native" in each.message]
    assert len(native) == 1
    assert "does not compile it" not in native[0]
