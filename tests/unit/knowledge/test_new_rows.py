"""A release that nobody has made yet is one row of a table: the whole program then knows it."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

DISTRO = (
    "name,ros,ubuntu,releases,python,released,eol,rosdistro_tag,arm64,preference,default,middleware,word,image,source,date",
    "zephyr,2,{ubuntu},{ubuntu},3.14,2027-05-23,2032-05-31,,yes,9,no,rmw_fastrtps_cpp,yes,yes,https://example.org,2027-05-23",
)
UBUNTU = (
    "codename,version,python,cmake,released,ended,source,date",
    "sparkling,28.04,3.16,4.6,2028-04-20,2033-04-30,https://example.org,2028-04-20",
)
MANIFEST = """\
<package format="3">
  <name>robot</name><version>1.0.0</version><description>x</description>
  <maintainer email="a@b.org">a</maintainer><license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>
</package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.8)\nproject(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"


def with_row(folder: Path, checkout: Path, table: str, columns: str, row: str) -> None:
    """Copy the program with one more row in a table, which must have the columns that the row was written for."""
    if not folder.exists():
        shutil.copytree(checkout / "scripts", folder, ignore=shutil.ignore_patterns("__pycache__"))
    path = folder / "roslab" / "knowledge" / f"{table}.csv"
    text = path.read_text(encoding="utf-8")
    assert text.startswith(columns + "\n")
    path.write_text(f"{text}{row}\n", encoding="utf-8")


def plan(program: Path, repository: Path, *arguments: str) -> tuple[dict[str, Any], str]:
    """Return what ``plan`` prints and the Dockerfile that ``create`` writes."""
    command = [sys.executable, "-I", str(program)]
    answer = subprocess.run(
        [*command, "plan", str(repository), *arguments], capture_output=True, text=True, check=False, timeout=60
    )
    assert answer.returncode == 0, answer.stderr
    output = repository.parent / "output"
    subprocess.run([*command, "create", str(repository), "--output", str(output), *arguments], check=True, timeout=60)
    return json.loads(answer.stdout), (output / "Dockerfile").read_text(encoding="utf-8")


def repository(folder: Path, readme: str, *, ros: bool = True) -> Path:
    folder.mkdir()
    (folder / "README.md").write_text(readme)
    (folder / "CMakeLists.txt").write_text(CMAKE if ros else "project(robot CXX)\nadd_executable(robot main.cpp)\n")
    (folder / "main.cpp").write_text("int main() {}\n")
    if ros:
        (folder / "package.xml").write_text(MANIFEST)
    return folder


@pytest.mark.parametrize(
    ("readme", "arguments"),
    [
        ("# Robot\n\nTested on ROS 2 Zephyr.\n", ()),
        ("# Robot\n\n```\nsudo apt install ros-zephyr-nav2-bringup\n```\n", ()),
        ("# Robot\n", ("--branch", "zephyr-devel")),
    ],
    ids=["page", "install-line", "branch"],
)
def test_a_new_distribution_is_one_row(readme: str, arguments: tuple[str, ...], checkout: Path, tmp_path: Path) -> None:
    program = tmp_path / "scripts"
    with_row(program, checkout, "distros", DISTRO[0], DISTRO[1].format(ubuntu="resolute"))
    found, dockerfile = plan(program, repository(tmp_path / "robot", readme), *arguments)
    assert (found["kind"], found["ros_distro"], found["ubuntu"]) == ("ros2", "zephyr", "resolute")
    assert (found["base_image"], found["warnings"]) == ("ros:zephyr-ros-base", [])
    assert "FROM ros:zephyr-ros-base" in dockerfile
    assert found["rosdep"]["manifests"] == ["package.xml"]
    assert "rosdep" in dockerfile
    if "nav2" in readme:
        assert "ros-zephyr-nav2-bringup" in found["apt_guessed"]


def test_a_new_ubuntu_is_one_row(checkout: Path, tmp_path: Path) -> None:
    program = tmp_path / "scripts"
    with_row(program, checkout, "ubuntu", *UBUNTU)
    robot = repository(tmp_path / "robot", "# Robot\n\nRuns on Ubuntu 28.04.\n", ros=False)
    found, dockerfile = plan(program, robot)
    assert (found["kind"], found["ubuntu"], found["base_image"]) == ("cpp", "sparkling", "ubuntu:28.04")
    assert "FROM ubuntu:28.04" in dockerfile


def test_a_new_distribution_on_a_new_ubuntu(checkout: Path, tmp_path: Path) -> None:
    program = tmp_path / "scripts"
    with_row(program, checkout, "ubuntu", *UBUNTU)
    with_row(program, checkout, "distros", DISTRO[0], DISTRO[1].format(ubuntu="sparkling"))
    found, _ = plan(program, repository(tmp_path / "robot", "# Robot\n\nNeeds ROS 2 on Ubuntu 28.04 (sparkling).\n"))
    assert (found["ros_distro"], found["ubuntu"]) == ("zephyr", "sparkling")
