"""What the author's Dockerfiles clone and install, where they are for several distributions."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Base, Config
from trees import decided

MANIFEST = (
    "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>"
    "<depend>acme_wheel</depend></package>"
)
CMAKE = "project(demo)\nfind_package(ament_cmake REQUIRED)\nfind_package(acme_wheel REQUIRED)\nament_package()\n"
CLONE = "RUN git clone -b {} https://github.com/lab/acme_wheel.git\n"
NEW = (
    "FROM nvidia/cuda:12.6.3-devel-ubuntu24.04\nARG ROS_DISTRO=jazzy\nRUN apt-get update && apt-get install -y espeak\n"
)
OLD = "FROM nvidia/cuda:12.1.1-devel-ubuntu22.04\nARG ROS_DISTRO=humble\nRUN apt-get update && apt-get install -y sox\n"


@pytest.mark.parametrize(
    ("page", "branch", "image", "apt"),
    [
        ("ROS 2 Humble in an image.\n", "old", "nvidia/cuda:12.1.1-devel-ubuntu22.04", "sox"),
        ("ROS 2 Jazzy in an image.\n", "new", "nvidia/cuda:12.6.3-devel-ubuntu24.04", "espeak"),
    ],
)
def test_those_for_the_chosen_one_tell(tmp_path: Path, page: str, branch: str, image: str, apt: str) -> None:
    files = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": CMAKE,
        "README.md": page,
        "docker/a.dockerfile": NEW + CLONE.format("new"),
        "docker/b.dockerfile": OLD + CLONE.format("old"),
    }
    found = decided(tmp_path, files)
    assert found.base_image == image
    assert [source.ref for source in found.source] == [branch]
    assert {"sox", "espeak"} & {*found.apt, *found.apt_guessed} == {apt}


def test_where_none_is_for_the_chosen_one_all_tell(tmp_path: Path) -> None:
    files = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": CMAKE,
        "README.md": "ROS 2 Iron.\n",
        "docker/a.dockerfile": "FROM ubuntu:22.04\nRUN apt-get update && apt-get install -y espeak\n",
        "docker/b.dockerfile": OLD + CLONE.format("old"),
    }
    found = decided(tmp_path, files, config=Config(base=Base(ros="iron")))
    assert [source.ref for source in found.source] == ["old"]
    assert {"sox", "espeak"} <= {*found.apt, *found.apt_guessed}
