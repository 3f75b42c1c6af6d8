"""A named release of Gazebo tells the distribution that it was packaged for, unless more is said."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.knowledge.distros import distros
from roslab.knowledge.gazebo_releases import gazebo_libraries, gazebo_releases
from roslab.repository.checkout import Repository

PACKAGE = {
    "package.xml": '<package format="3"><name>demo</name><depend>rclcpp</depend>'
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.8)\nproject(demo)\nament_package()\n",
}
LAUNCH = "# Start Gazebo {} here\nfrom launch import LaunchDescription\n"
REQUIRED = "find_package({} REQUIRED)\n"


def distro(tmp_path: Path, files: dict[str, str], date: str = "") -> str | None:
    for path, text in {**PACKAGE, **files}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    evidence = gather(Repository.open(tmp_path))
    if date:
        said = Mention(topic="date", value=date, source="commit", file=".git/HEAD", line=1, text="")
        evidence = replace(evidence, mentions=(*evidence.mentions, said))
    return decide(evidence, Config(), folder_name="demo").ros_distro


@pytest.mark.parametrize(
    "files",
    [
        {"README.md": "First install Gazebo Harmonic.\n"},
        {"README.md": "See https://gazebosim.org/docs/harmonic/install\n"},
        {
            "docs/installing/install_gazebo.md": "Go to [the pages](https://ignitionrobotics.org/docs/harmonic/install).\n"
        },
        {"README.md": "```\nsudo apt install gz-harmonic\n```\n"},
        {"README.md": "```\nexport GZ_VERSION=harmonic\n```\n"},
        {"launch/sim.launch.py": LAUNCH.format("Harmonic")},
        {"CMakeLists.txt": PACKAGE["CMakeLists.txt"] + REQUIRED.format("gz-sim8")},
    ],
)
def test_harmonic_is_jazzys(tmp_path: Path, files: dict[str, str]) -> None:
    assert distro(tmp_path, files) == "jazzy"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Gazebo Fortress", "humble"),
        ("Gazebo (Garden)", "humble"),
        ("Gazebo Ionic", "kilted"),
        ("Gazebo Fortress or Gazebo Harmonic", "humble"),  # the default: it names two
        ("A harmonic function near the gazebo", "humble"),
        ("Ubuntu 22.04 with Gazebo Harmonic", "humble"),
        ("Tested on ROS 2 Humble with Gazebo Harmonic", "humble"),
        ("https://docs.ros.org/en/humble/a.html and https://gazebosim.org/docs/harmonic/a", "humble"),
    ],
)
def test_what_pages_say(tmp_path: Path, text: str, expected: str) -> None:
    assert distro(tmp_path, {"README.md": f"{text}\n"}) == expected


def test_a_distribution_that_came_later_is_not_meant(tmp_path: Path) -> None:
    page = {"README.md": "Gazebo Harmonic\n"}
    assert distro(tmp_path, page, "2024-01-01") == "humble"
    assert distro(tmp_path, page, "2026-01-01") == "jazzy"


def test_libraries_for_several_releases_tell_nothing(tmp_path: Path) -> None:
    both = PACKAGE["CMakeLists.txt"] + REQUIRED.format("gz-sim8") + REQUIRED.format("ignition-gazebo6")
    assert distro(tmp_path, {"CMakeLists.txt": both}) == "humble"


@pytest.mark.parametrize(
    ("libraries", "page", "name"),
    [
        ("gz-cmake4", "Tested on ROS 2 Jazzy.", "kilted"),
        ("gz-cmake3 gz-sim8", "Tested on ROS 2 Kilted.", "jazzy"),
        ("gz-cmake3 gz-sim8", "Tested on ROS 2 Humble.", "humble"),
        ("gz-cmake3 gz-sim8 gz-sim7", "Gazebo Harmonic", "jazzy"),
        ("gz-cmake3", "Gazebo Harmonic. The branch `fortress` is for Gazebo Fortress.", "jazzy"),
        ("gz-sim8 gz-sim9", "Tested on ROS 2 Kilted.", "kilted"),
        ("ignition-gazebo6", "Tested on ROS 2 Jazzy.", "humble"),
        ("ignition-transport8", "Tested on ROS 2 Jazzy.", "jazzy"),
    ],
)
def test_a_distribution_with_another_gazebo_is_ruled_out(tmp_path: Path, libraries: str, page: str, name: str) -> None:
    cmake = PACKAGE["CMakeLists.txt"] + "".join(REQUIRED.format(each) for each in libraries.split())
    assert distro(tmp_path, {"CMakeLists.txt": cmake, "README.md": f"{page}\n"}) == name


@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("See [hooks](https://docs.ros.org/en/rolling/How-To-Guides/Ament.html).", "humble"),
        ("Install ROS 2 [rolling](https://docs.ros.org/en/rolling/Installation.html).", "kilted"),
        ("Install [ROS 2](https://docs.ros.org/en/iron/Installation.html).", "iron"),
    ],
)
def test_an_address_of_the_documentation(tmp_path: Path, page: str, name: str) -> None:
    assert distro(tmp_path, {"README.md": f"{page}\n"}, "2025-01-21") == name


def test_the_table_names_distributions_with_an_image() -> None:
    assert set(gazebo_releases().values()) <= distros().keys()
    assert len(gazebo_libraries()) == 3 * len(gazebo_releases())
