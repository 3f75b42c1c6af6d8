"""Modules of CMake that a package of Ubuntu has in a folder where CMake does not look."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

MODULE = "/usr/share/cmake/geographiclib/FindGeographicLib.cmake"
PACKAGE = "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
CMAKE = "project(demo)\nfind_package(ament_cmake REQUIRED)\n{}add_executable(demo demo.cpp)\n"
ASKED = "find_package(GeographicLib REQUIRED)\n"


def planned(folder: Path, cmake: str, **others: str) -> str:
    files = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": CMAKE.format(cmake),
        "README.md": "ROS 2 Humble\n",
        "demo.cpp": "int main() {}\n",
        **others,
    }
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")
    return dockerfile(plan_repository(folder).plan)


def test_it_is_linked_where_cmake_looks_before_anything_is_compiled(tmp_path: Path) -> None:
    text = planned(tmp_path, ASKED)
    link = f'ln -sf {MODULE} "${{folder}}"'
    assert text.index("libgeographic-dev") < text.index(link) < text.index("colcon build")


@pytest.mark.parametrize(
    ("cmake", "others"),
    [
        ("", {}),
        (f"# {ASKED}", {}),
        (f"list(APPEND CMAKE_MODULE_PATH /usr/share/cmake/geographiclib)\n{ASKED}", {}),
        (ASKED, {"cmake/FindGeographicLib.cmake": "find_path(GeographicLib_INCLUDE_DIRS GeographicLib/Config.h)\n"}),
        (ASKED.replace("Lib ", "LibTools "), {}),
    ],
    ids=["not-asked", "comment", "named-folder", "own-module", "another"],
)
def test_nothing_is_linked_that_cmake_finds_or_is_not_asked_for(
    tmp_path: Path, cmake: str, others: dict[str, str]
) -> None:
    assert MODULE not in planned(tmp_path, cmake, **others)
