"""NVIDIA's image of CUDA with OpenGL, where nothing is for CUDA, stands for a GPU that draws."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
}
IMAGE = "FROM nvidia/cudagl:11.1.1-{flavour}-ubuntu20.04\nRUN apt-get install -y ros-noetic-ros-base\n"


@pytest.mark.parametrize(
    ("flavour", "further", "image"),
    [
        ("base", {}, "ros:noetic-ros-base"),
        ("runtime", {}, "ros:noetic-ros-base"),
        ("devel", {}, "nvidia/cuda:11.1.1-devel-ubuntu20.04"),
        ("base", {"src/a.cu": ""}, "nvidia/cuda:11.1.1-devel-ubuntu20.04"),
        ("base", {"src/a.py": "import torch\n"}, "nvidia/cuda:11.1.1-devel-ubuntu20.04"),
        ("base", {"README.md": "Tested with ROS Noetic and CUDA 11.1.\n"}, "nvidia/cuda:11.1.1-devel-ubuntu20.04"),
    ],
)
def test_the_image_and_the_gpu(tree: Tree, flavour: str, further: dict[str, str], image: str) -> None:
    decision = tree({**FILES, "docker/nvidia.Dockerfile": IMAGE.format(flavour=flavour), **further})
    assert (decision.base_image, decision.gpu) == (image, True)
    assert (decision.cuda is None) is image.startswith("ros:")
    assert ("linux/arm64" in decision.platforms) is image.startswith("ros:")
