"""Rolling moves from Ubuntu to Ubuntu: what only today's lacks lets no outdated image win."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

FILES = {
    "package.xml": '<package format="3"><name>demo</name><depend>bondcpp</depend>'
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(Ceres REQUIRED)\n"
    "add_executable(a a.cpp)\n",
    "a.cpp": "ceres::LocalParameterization * a;\n",
    "Dockerfile": "FROM ros:eloquent-ros-base-bionic\nCOPY . /ws/src/demo\nRUN colcon build\n",
}


def decided(tmp_path: Path, date: str = "", code: str = FILES["a.cpp"]) -> Decision:
    for path, text in {**FILES, "a.cpp": code}.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    evidence = gather(Repository.open(tmp_path, branch="ros2"))
    if date:
        said = Mention(topic="date", value=date, source="commit", file=".git/HEAD", line=1, text="")
        evidence = replace(evidence, mentions=(*evidence.mentions, said))
    return decide(evidence, Config(), folder_name="demo")


def told(decision: Decision) -> bool:
    return any("today's ROS rolling has no Ceres older than 2.2" in warning.message for warning in decision.warnings)


def test_without_a_date_rolling_stays_and_what_it_lacks_is_told(tmp_path: Path) -> None:
    found = decided(tmp_path)
    assert found.ros_distro == "rolling"
    assert told(found)


def test_code_that_todays_rolling_has_everything_for(tmp_path: Path) -> None:
    found = decided(tmp_path, code="int a;\n")
    assert found.ros_distro == "rolling"
    assert not told(found)


def test_with_a_date_it_is_a_distribution_that_the_code_compiles_with(tmp_path: Path) -> None:
    found = decided(tmp_path, "2024-03-03")
    assert found.ros_distro == "humble"
    assert not told(found)
    assert decided(tmp_path, "2024-03-03", code="int a;\n").ros_distro == "jazzy"


TESTED = "The instructions are for ROS 2, tested on Humble on Ubuntu 22.04.\n"


@pytest.mark.parametrize(
    ("readme", "date", "distro"),
    [
        (TESTED, "2023-12-20", "humble"),
        (TESTED, "", "rolling"),  # nothing tells whether the sentence is older than the code
        (TESTED.replace("Humble", "Iron"), "2025-06-01", "lyrical"),  # it had ended, and the branch went on
        (f"{TESTED}Jazzy works too.\n", "2024-10-10", "kilted"),  # the page names several
        ("Humble had a bug.\n", "2023-12-20", "jazzy"),  # no word of a test
        ("For example, tested on humble:\n", "2023-12-20", "jazzy"),
    ],
)
def test_the_one_release_that_the_readme_was_tested_on(tmp_path: Path, readme: str, date: str, distro: str) -> None:
    files = {**FILES, "a.cpp": "int a;\n", "README.md": readme}
    del files["Dockerfile"]
    for path, text in files.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    evidence = gather(Repository.open(tmp_path, branch="ros2"))
    if date:
        said = Mention(topic="date", value=date, source="commit", file=".git/HEAD", line=1, text="")
        evidence = replace(evidence, mentions=(*evidence.mentions, said))
    assert decide(evidence, Config(), folder_name="demo").ros_distro == distro
