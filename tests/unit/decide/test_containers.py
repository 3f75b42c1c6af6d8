"""The images of an author's containers tell what the code is for: Docker Compose files, Dev Containers."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
ROS = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
COMPOSE = "services:\n  demo:\n    image: {image}\n    volumes: ['.:/ws/src']\n"
DEV = '{{\n  // "image": "ros:kinetic",\n  "name": "demo", // focal or bionic of Ubuntu\n  "image": "{image}"\n}}\n'
BUILT = "services:\n  demo:\n    build:\n      context: .\n      args:\n        ROS_DISTRO: melodic\n"
FAMILY = "services:\n" + "".join(f"  {each}:\n    image: ros:{each}\n" for each in ("kinetic", "melodic", "noetic"))


@pytest.mark.parametrize(
    ("files", "distro"),
    [
        ({"docker-compose.yml": COMPOSE.format(image="osrf/ros:melodic-desktop-full")}, "melodic"),
        ({"docker/compose.dev.yaml": COMPOSE.format(image="'ros:${ROS_DISTRO:-melodic}'")}, "melodic"),
        ({".devcontainer/devcontainer.json": DEV.format(image="ros:melodic")}, "melodic"),
        ({".devcontainer/devcontainer.json": DEV.format(image="ubuntu:18.04")}, "melodic"),
        ({"docker-compose.yml": BUILT}, "melodic"),
        ({"docker-compose.yml": COMPOSE.format(image="redis:7")}, "noetic"),
        ({"docker-compose.yml": FAMILY, "README.md": "ROS Kinetic\n"}, "kinetic"),
        ({"examples/docker-compose.yml": COMPOSE.format(image="ros:melodic")}, "noetic"),
        ({"docker-compose.yml": COMPOSE.format(image="ros:melodic"), "README.md": "Needs ROS Kinetic\n"}, "melodic"),
        ({"docker-compose.yml": COMPOSE.format(image="ros:melodic"), "Dockerfile": "FROM ros:kinetic\n"}, "kinetic"),
    ],
)
def test_the_distribution_of_a_container(tree: Tree, files: dict[str, str], distro: str) -> None:
    assert tree({**ROS, **files}).ros_distro == distro


def test_the_python_and_cuda_of_a_container(tree: Tree) -> None:
    program = {"main.py": "import torch\nif __name__ == '__main__':\n    pass\n", "requirements.txt": "torch\n"}
    image = "nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04"
    assert tree({**program, ".devcontainer/devcontainer.json": DEV.format(image=image)}).cuda == "11.3"


def test_the_python_of_a_dev_container(tree: Tree) -> None:
    image = "mcr.microsoft.com/devcontainers/python:3.9"
    program = {"main.py": "import numpy\nif __name__ == '__main__':\n    pass\n"}
    found = tree({**program, ".devcontainer/devcontainer.json": DEV.format(image=image)})
    assert found.python.version == "3.9"
