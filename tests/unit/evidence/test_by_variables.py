"""Packages of ROS that only variables of CMake lead to."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import by_variables
from roslab.repository.checkout import Repository

BARE = "find_package(ompl REQUIRED)\ntarget_link_libraries(planner ompl)\n"
BY_VARIABLES = "find_package( OMPL )\ninclude_directories(${OMPL_INCLUDE_DIRS})\n"


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"CMakeLists.txt": BARE}, {"ompl"}),
        ({"CMakeLists.txt": BY_VARIABLES}, set()),
        ({"CMakeLists.txt": BARE.replace("ompl)", "ompl::ompl)")}, set()),
        ({"a/CMakeLists.txt": BARE, "b/CMakeLists.txt": BY_VARIABLES}, set()),
        ({"CMakeLists.txt": "add_executable(ompl_demo a.cpp)\n"}, set()),
        ({"third_party/a/CMakeLists.txt": BARE}, set()),
    ],
)
def test_packages_without_their_variables(tmp_path: Path, files: dict[str, str], found: set[str]) -> None:
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    assert by_variables.read(Repository.open(tmp_path)) == found
