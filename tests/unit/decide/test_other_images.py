"""A Dockerfile that has neither ROS nor this code is for something else: its Ubuntu names no distribution."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

CATKIN = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>rospy</depend></package>"
CMAKE = "project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
CUDA = "FROM nvidia/cuda:11.3.0-devel-ubuntu18.04\nRUN apt-get update && apt-get install -y cmake python3-pip\n"
FILES = {"package.xml": CATKIN, "CMakeLists.txt": CMAKE, "Dockerfile": CUDA}
DAY = "2023-04-25"


@pytest.mark.parametrize(
    ("recipe", "distro"),
    [
        (CUDA, "noetic"),
        (f"{CUDA}RUN pip3 install torch==1.10.0 catkin_pkg rospkg\n", "noetic"),
        (f"{CUDA}RUN wget https://a.org/Miniconda3-latest.sh && bash Miniconda3-latest.sh -b\n", "noetic"),
        (f"{CUDA}RUN apt-get install -y ros-base\n", "melodic"),
        (f"{CUDA}RUN catkin_make\n", "melodic"),
        (f"{CUDA}RUN ./install.sh\n", "melodic"),
        (f"{CUDA}COPY . /src\nRUN cmake /src\n", "melodic"),
        (CUDA.replace("nvidia/cuda", "lab/robot"), "melodic"),
    ],
)
def test_the_ubuntu_of_an_image(tmp_path: Path, recipe: str, distro: str) -> None:
    found = decided(tmp_path, {**FILES, "Dockerfile": recipe}, DAY)
    assert found.ros_distro == distro


def test_it_tells_where_nothing_else_does(tmp_path: Path) -> None:
    assert decided(tmp_path, FILES).ros_distro == "melodic"


def test_a_page_tells_more(tmp_path: Path) -> None:
    files = {**FILES, "README.md": "Tested on Ubuntu 18.04.\n"}
    assert decided(tmp_path, files, DAY).ros_distro == "melodic"
