"""A library of which a distribution of ROS released what is older than the code of its time: it is compiled instead."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

FILES = {
    "package.xml": "<package format='2'><name>plans</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": (
        "project(plans)\nfind_package(catkin REQUIRED)\nfind_package(sbpl REQUIRED)\ncatkin_package()\n"
        "add_executable(plan plan.cpp)\ntarget_link_libraries(plan ${SBPL_LIBRARIES})\n"
    ),
    "plan.cpp": "#include <sbpl/headers.h>\nint main() {}\n",
}


@pytest.mark.parametrize(
    ("distro", "built", "of_ros"),
    [("indigo", ["sbpl"], set[str]()), ("kinetic", [], {"ros-kinetic-sbpl"}), ("noetic", [], {"ros-noetic-sbpl"})],
)
def test_it_is_taken_from_its_source(tmp_path: Path, distro: str, built: list[str], of_ros: set[str]) -> None:
    decision = decided(tmp_path, FILES, branch=f"{distro}-devel")
    assert [source.name for source in decision.source] == built
    assert {name for name in (*decision.apt, *decision.apt_guessed) if name.endswith("sbpl")} == of_ros


def test_a_header_alone_finds_what_ros_released_elsewhere(tmp_path: Path) -> None:
    files = FILES | {"CMakeLists.txt": FILES["CMakeLists.txt"].replace("find_package(sbpl REQUIRED)\n", "")}
    assert "ros-kinetic-sbpl" in decided(tmp_path, files, branch="kinetic-devel").apt_guessed
