"""The distribution where the author has Dockerfiles for several, of which none tells more than another."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

MANIFEST = "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend></package>"
OF_CUDA = (
    "FROM nvidia/cuda:12.6.3-devel-ubuntu22.04\nARG ROS_DISTRO={}\nRUN apt-get install -y ros-$ROS_DISTRO-desktop\n"
)


@pytest.mark.parametrize(
    ("page", "distro"),
    [
        ("An image with ROS 2 Humble and CUDA 12.\n", "humble"),
        ("An image with ROS 2 Jazzy and CUDA 12.\n", "jazzy"),
        ("Tested on ROS 2 Humble.\n\nTested on ROS 2 Jazzy.\n", "jazzy"),
        ("A paper.\n", "jazzy"),
    ],
)
def test_what_a_page_says_decides(tmp_path: Path, page: str, distro: str) -> None:
    files = {
        "package.xml": MANIFEST,
        "README.md": page,
        "docker/x86.dockerfile": OF_CUDA.format("humble"),
        "docker/x86_new.dockerfile": OF_CUDA.format("jazzy"),
    }
    found = decided(tmp_path, files)
    assert found.ros_distro == distro
    why = next(each.reason for each in found.reasons if each.question == "ros_distro" and each.answer == distro)
    assert ("“" in why) == (page.count("ROS 2") == 1)


def test_a_page_does_not_outweigh_the_only_dockerfile(tmp_path: Path) -> None:
    files = {
        "package.xml": MANIFEST,
        "README.md": "An image with ROS 2 Humble.\n",
        "docker/x86.dockerfile": OF_CUDA.format("jazzy"),
    }
    assert decided(tmp_path, files).ros_distro == "jazzy"
