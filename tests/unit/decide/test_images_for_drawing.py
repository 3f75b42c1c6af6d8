"""An author's image of NVIDIA's for drawing alone has no CUDA, and neither has the image of ROS then."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CATKIN = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>rospy</depend></package>"
FILES = {"package.xml": CATKIN, "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"}
IMAGE = "FROM {}\nRUN apt-get install -y ros-noetic-ros-base\nCOPY . /ws/src/a\n"


@pytest.mark.parametrize(
    ("dockerfiles", "base"),
    [
        ({"a.dockerfile": "nvidia/opengl:1.2-glvnd-runtime-ubuntu20.04"}, "ros:noetic-ros-base"),
        (
            {
                "a.dockerfile": "nvidia/opengl:1.2-glvnd-runtime-ubuntu20.04",
                "a_cuda.dockerfile": "nvidia/cudagl:11.3.0-runtime-ubuntu20.04",
            },
            "ros:noetic-ros-base",
        ),
        ({"a.dockerfile": "nvidia/cuda:11.3.0-devel-ubuntu20.04"}, "nvidia/cuda:11.3.1-devel-ubuntu20.04"),
        ({"a.dockerfile": "nvidia/cudagl:11.3.0-devel-ubuntu20.04"}, "nvidia/cuda:11.3.1-devel-ubuntu20.04"),
    ],
)
def test_the_base(tree: Tree, dockerfiles: dict[str, str], base: str) -> None:
    files = {f"docker/{name}": IMAGE.format(image) for name, image in dockerfiles.items()}
    found = tree({**FILES, **files, "README.md": "ROS Noetic\n"})
    assert (found.ros_distro, found.base_image) == ("noetic", base)
