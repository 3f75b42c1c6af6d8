"""What a package links and makes itself, below a folder that it adds or includes, is not cloned from a page."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
PAGE = (
    "# Odd slam\n```\ncd ~/ws/src\ngit clone https://github.com/lab/ODD_SLAM.git\n```\n"
    "Uses [DBowX](https://github.com/lab/DBowX).\n"
)
LINKS = "add_library(demo a.cpp)\ntarget_link_libraries(demo ODD_SLAM DBowX)\n"


def files(top: str, slam: str, **others: str) -> dict[str, str]:
    return {
        "package.xml": PACKAGE,
        "README.md": "ROS 2 Humble\n",
        "a.cpp": "int a;\n",
        "CMakeLists.txt": f"project(demo)\nfind_package(ament_cmake REQUIRED)\n{top}{LINKS}",
        "slam/README.md": PAGE,
        "slam/CMakeLists.txt": f"project(ODD_SLAM)\nadd_library(${{PROJECT_NAME}} b.cpp)\n{slam}",
        "slam/bow/CMakeLists.txt": "add_library(DBowX c.cpp)\n",
        **others,
    }


def cloned(decision: Decision) -> list[str]:
    return sorted(each.name for each in decision.source)


@pytest.mark.parametrize("top", ["add_subdirectory(slam)\n", "add_subdirectory(${CMAKE_CURRENT_SOURCE_DIR}/slam)\n"])
@pytest.mark.parametrize("slam", ["add_subdirectory(bow)\n", "include(${PROJECT_SOURCE_DIR}/bow/CMakeLists.txt)\n"])
def test_it_is_no_need(tree: Tree, top: str, slam: str) -> None:
    assert cloned(tree(files(top, slam))) == []


@pytest.mark.parametrize(
    ("top", "slam", "names"),
    [
        ("", "add_subdirectory(bow)\n", ["DBowX", "ODD_SLAM"]),
        ("add_subdirectory(slam)\n", "", ["DBowX"]),
        ("if(WITH_SLAM)\nadd_subdirectory(slam)\nendif()\n", "add_subdirectory(bow)\n", ["ODD_SLAM"]),
    ],
)
def test_what_no_usual_build_makes_is_needed(tree: Tree, top: str, slam: str, names: list[str]) -> None:
    assert cloned(tree(files(top, slam))) == names
