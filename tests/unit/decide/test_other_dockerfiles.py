"""A Dockerfile under a name of its own tells the distribution, and no image is made with it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

BASE = "# The base\nARG BASEIMG=osrf/ros:noetic-desktop-full\nFROM $BASEIMG\n\nCOPY . /ws/src/a\n"


@pytest.mark.parametrize(
    ("path", "text", "name"),
    [
        ("dockerfiles/base", BASE, "noetic"),
        (".docker/noetic", BASE.replace("$BASEIMG", "${BASEIMG} AS base"), "noetic"),
        ("containers/ros/base", BASE, "melodic"),
        ("data/base", BASE, "melodic"),
        ("docker/notes", "From noetic on, this works with osrf/ros:noetic-desktop-full.\n", "melodic"),
        ("docker/run", "#!/bin/bash\ndocker run osrf/ros:noetic-desktop-full\n", "melodic"),
        ("docker/base.md", BASE, "melodic"),
    ],
)
def test_what_begins_like_a_dockerfile_in_their_folder_is_one(tmp_path: Path, path: str, text: str, name: str) -> None:
    xml = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>"
    cmake = "project(a)\nfind_package(catkin REQUIRED)\n"
    page = "# A\n\n## Tested on\n\n- ROS Melodic\n"
    for file, content in {"package.xml": xml, "CMakeLists.txt": cmake, "README.md": page, path: text}.items():
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text(content)
    decided = decide(gather(Repository.open(tmp_path)), Config(), folder_name="a")
    assert decided.ros_distro == name
    assert decided.dockerfile is None
