"""The ROS distribution of who installs by apt what only older Ubuntus have."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

MANIFEST = (
    "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><build_depend>roscpp</build_depend></package>"
)
FILES = {"package.xml": MANIFEST, "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"}


@pytest.mark.parametrize(
    ("page", "ros"),
    [
        ("sudo apt-get install python-wstool python-catkin-tools", "melodic"),
        ("sudo apt-get install python-rosdep", "melodic"),
        ("sudo apt-get install python3-catkin-tools", "noetic"),
        ("sudo apt-get install python-catkin-tools\nsudo apt-get install python3-catkin-tools", "noetic"),
        ("sudo apt-get install python-catkin-tools libpng12-dev", "kinetic"),
        ("sudo apt-get install python-catkin-tools ros-noetic-tf", "noetic"),
        ("sudo apt-get install python-numpy", "noetic"),
        ("It runs on Ubuntu 20.04.\n\n    sudo apt-get install python-catkin-tools", "noetic"),
    ],
)
def test_names_of_packages_tell_more_than_no_name_and_less_than_one(tmp_path: Path, page: str, ros: str) -> None:
    found = decided(tmp_path, {**FILES, "README.md": f"# demo\n\n```\n{page}\n```\n"})
    assert found.ros_distro == ros


@pytest.mark.parametrize(
    ("packages", "date", "ros"),
    [
        ("python-catkin-tools", "2019-03-01", "melodic"),
        ("python-catkin-tools", "2021-06-18", "melodic"),  # noetic was out, and most had not moved
        ("python-catkin-tools", "2023-01-19", "noetic"),  # the page was not changed when its authors moved
        ("python-rosdep python-wstool", "2022-11-29", "noetic"),
        ("libqt4-dev", "2023-01-19", "melodic"),  # the code needs it: no newer Ubuntu has it under another name
        ("libpng12-dev python-catkin-tools", "2023-01-19", "kinetic"),
    ],
)
def test_the_old_name_of_a_tool_tells_nothing_years_later(tmp_path: Path, packages: str, date: str, ros: str) -> None:
    page = f"# demo\n\n```\nsudo apt install {packages}\n```\n"
    assert decided(tmp_path, {**FILES, "README.md": page}, date).ros_distro == ros
