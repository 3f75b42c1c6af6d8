"""The script that finds what CMake of cloned packages requires of ROS beyond their package.xml."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

pytestmark = pytest.mark.usefixtures("scripts_on_path")
SCRIPT = Path(image_scripts.__path__[0]) / "required-components.sh"


@pytest.mark.parametrize(
    ("cmake", "packages"),
    [
        ("find_package(catkin REQUIRED COMPONENTS roscpp pcl_ros mine)", ["ros-noetic-pcl-ros"]),
        ("find_package(catkin COMPONENTS\n roscpp\n pcl_ros # or\n tf2)\n", ["ros-noetic-pcl-ros", "ros-noetic-tf2"]),
        ("FIND_PACKAGE( catkin COMPONENTS pcl_ros )", ["ros-noetic-pcl-ros"]),
        ("# find_package(catkin REQUIRED COMPONENTS pcl_ros)\nfind_package(catkin REQUIRED)", []),
        ("find_package(rclcpp REQUIRED)\nfind_package(Eigen3 REQUIRED)\nfind_package(tf2)", ["ros-noetic-rclcpp"]),
        ("find_package(catkin REQUIRED COMPONENTS ${NEEDED} roscpp)", []),
        ("project(mine)\n", []),
    ],
)
def test_what_neither_ros_nor_the_workspace_has(tmp_path: Path, cmake: str, packages: list[str]) -> None:
    for path in ("ros/noetic/share/roscpp", "ws/mine"):
        (tmp_path / path).mkdir(parents=True)
    (tmp_path / "ws/mine/package.xml").write_text("<package>\n  <name>mine</name>\n</package>\n")
    (tmp_path / "ws/mine/CMakeLists.txt").write_text(cmake)
    script = tmp_path / "script"
    script.write_text(SCRIPT.read_text().replace("/opt/ros/", f"{tmp_path}/ros/"))
    ran = subprocess.run(
        ["bash", script, tmp_path / "ws"],
        env=os.environ | {"ROS_DISTRO": "noetic"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert ran.stdout.split() == packages


def test_without_ros_there_is_nothing_to_ask(tmp_path: Path) -> None:
    ran = subprocess.run(
        ["bash", SCRIPT, tmp_path], env=os.environ | {"ROS_DISTRO": "none"}, capture_output=True, text=True, check=True
    )
    assert ran.stdout == ""
