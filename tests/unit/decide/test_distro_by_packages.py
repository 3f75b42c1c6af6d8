"""The ROS distribution of who installs by apt what only older Ubuntus have."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace

MANIFEST = (
    "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><build_depend>roscpp</build_depend></package>"
)


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
    (tmp_path / "package.xml").write_text(MANIFEST, encoding="utf-8")
    (tmp_path / "CMakeLists.txt").write_text("project(demo)\nfind_package(catkin REQUIRED)\n", encoding="utf-8")
    (tmp_path / "README.md").write_text(f"# demo\n\n```\n{page}\n```\n", encoding="utf-8")
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
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
    (tmp_path / "package.xml").write_text(MANIFEST, encoding="utf-8")
    (tmp_path / "CMakeLists.txt").write_text("project(demo)\nfind_package(catkin REQUIRED)\n", encoding="utf-8")
    (tmp_path / "README.md").write_text(f"# demo\n\n```\nsudo apt install {packages}\n```\n", encoding="utf-8")
    evidence = gather(Repository.open(tmp_path))
    day = Mention(topic="date", value=date, text="", file=".git/HEAD", line=1, source="commit")
    found = decide(replace(evidence, mentions=(*evidence.mentions, day)), Config(), folder_name="demo")
    assert found.ros_distro == ros
