"""``date``: what the plan takes of a past day, and what it names that cannot be had of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.errors import ConfigurationError
from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan, from_json, to_json
from roslab.render.dockerfile import dockerfile
from roslab.render.report import inspection_json, inspection_text
from trees import commit, tree_of

PACKAGE = """\
<package format="2">
  <name>robot</name><version>1.0.0</version><description>x</description>
  <maintainer email="a@example.org">a</maintainer><license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend>
</package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject(robot)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
ROS1 = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE}
PYTHON = {"main.py": "import numpy\n\nprint(numpy.zeros(3))\n", "requirements.txt": "numpy\n"}
CPP = {"CMakeLists.txt": "project(robot CXX)\nadd_executable(robot main.cpp)\n", "main.cpp": "int main() {}\n"}


def plan(folder: Path, files: dict[str, str], config: str) -> Plan:
    tree_of(folder, {**files, "roslab.yaml": f"format: 3\n{config}"})
    return plan_repository(folder).plan


@pytest.mark.parametrize(
    ("day", "distro", "tables", "ros"),
    [
        ("2017-03-01", "kinetic", "55d26753612d93f2d915e99b8b068626928e4fb9", "final"),
        ("2021-01-20", "melodic", "melodic/2020-12-21", "2020-12-21"),
        ("2022-06-01", "noetic", "noetic/2022-05-18", "2022-05-18"),
    ],
)
def test_ros_is_of_the_day(tmp_path: Path, day: str, distro: str, tables: str, ros: str) -> None:
    named = f"base: {{ros: {distro}}}\n" if distro == "melodic" else ""
    found = plan(tmp_path, ROS1, f"date: {day}\n{named}")
    assert found.ros_distro == distro
    assert found.rosdep
    assert found.rosdep.rosdistro_tag == tables
    assert found.package_sources
    assert found.package_sources.ros
    assert f"/{distro}/{ros}/ubuntu" in found.package_sources.ros.url
    text = dockerfile(found)
    assert f"    take-snapshots {day}" in text
    assert f'eval "$(index-as-of {day})"' in text
    assert from_json(to_json(found)) == found


def test_what_has_no_snapshot_is_named(tmp_path: Path) -> None:
    found = plan(tmp_path, ROS1, "date: 2017-03-01\nbase: {ros: kinetic}\n")
    said = " / ".join(warning.message for warning in found.warnings)
    assert "Ubuntu has no snapshot before 2023-03-01" in said
    assert "no snapshot of ROS kinetic of that time" in said
    assert "rosdep's tables are of 2018-11-29" in said


@pytest.mark.parametrize(
    ("files", "day", "base"),
    [
        (PYTHON, "2019-05-20", "ubuntu:16.04"),
        (PYTHON, "2024-05-20", "ubuntu:22.04"),
        (CPP, "2019-05-20", "ubuntu:18.04"),
        (CPP, "2024-05-20", "ubuntu:22.04"),
    ],
)
def test_no_base_is_newer_than_the_day(tmp_path: Path, files: dict[str, str], day: str, base: str) -> None:
    assert plan(tmp_path, files, f"date: {day}\n").base_image in {base, "python:3.7-slim-bookworm"}


def test_a_distribution_that_came_later_is_taken_where_the_author_names_it_alone(tmp_path: Path) -> None:
    said = {"README.md": "# Robot\n\nTested on ROS Noetic.\n"}
    (tmp_path / "named").mkdir()
    assert plan(tmp_path / "named", ROS1, "date: 2018-12-01\nbase: {ros: noetic}\n").ros_distro == "noetic"
    assert plan(tmp_path, ROS1 | said, "date: 2018-12-01\n").ros_distro in {"kinetic", "melodic"}


def test_clones_are_of_the_day(tmp_path: Path) -> None:
    source = "source: [{name: sister, repo: 'https://example.org/sister.git', ref: main, build: catkin_make}]\n"
    text = dockerfile(plan(tmp_path, ROS1, f"date: 2022-06-01\n{source}"))
    assert "checkout-branch /home/${NB_USER}/ws/src/sister main" in text
    assert "--before=2022-06-01T23:59:59Z" in text


def test_what_a_list_alone_imports_is_of_the_time_of_its_commit(tmp_path: Path) -> None:
    listed = "{type: git, url: 'https://github.com/lab/arm.git', version: master}"
    (tmp_path / "all.repos").write_text(f"repositories:\n  arm: {listed}\n")
    (tmp_path / "README.md").write_text("For ROS Melodic: `vcs import src < all.repos`\n")
    commit(tmp_path, "2020-07-09")
    (source,) = plan(tmp_path, {}, "").workspace.sources
    assert (source.ref, source.before) == ("master", "2020-07-09")


@pytest.mark.parametrize(
    ("distro", "needed", "before"),
    [
        ("Melodic", "mrs_lib", "2020-07-09"),
        ("Noetic", "mrs_lib", ""),  # nobody had worked on it for a year
        ("Melodic", "livox_ros_driver", ""),  # a release, which stays what it is
    ],
)
def test_what_the_table_clones_is_not_newer_than_the_repository(
    tmp_path: Path, distro: str, needed: str, before: str
) -> None:
    needs = f"<buildtool_depend>catkin</buildtool_depend><depend>{needed}</depend>"
    (tmp_path / "package.xml").write_text(f"<package><name>demo</name>{needs}</package>")
    (tmp_path / "CMakeLists.txt").write_text(f"find_package(catkin REQUIRED COMPONENTS {needed})\n")
    (tmp_path / "README.md").write_text(f"For ROS {distro}.\n")
    commit(tmp_path, "2020-07-09")
    found = plan(tmp_path, {}, "").workspace.sources
    assert found
    assert {source.before for source in found} == {before}


def test_the_day_of_the_paper(tmp_path: Path) -> None:
    found = plan(tmp_path, ROS1, "date: paper\n")
    assert found.as_of is None
    assert "neither a commit nor a citation file" in found.warnings[0].message
    (tmp_path / "CITATION.cff").write_text("cff-version: 1.2.0\npreferred-citation:\n  year: 2021\n")
    found = plan(tmp_path, ROS1, "date: paper\n")
    assert found.as_of
    assert found.as_of.day == "2021-12-31"
    commit(tmp_path, "2020-07-09")
    found = plan(tmp_path, ROS1, "date: paper\n")
    assert found.as_of
    assert found.as_of.day == "2020-07-09"


@pytest.mark.parametrize(
    ("day", "distro"), [("2020-12-01", "eloquent"), ("2022-06-01", "foxy"), ("2024-05-01", "humble")]
)
def test_ci_that_was_left_behind_tells_nothing_of_a_later_day(tmp_path: Path, day: str, distro: str) -> None:
    manifest = PACKAGE.replace("catkin", "ament_cmake").replace("roscpp", "rclcpp")
    cmake = CMAKE.replace("catkin_package", "ament_package").replace("catkin", "ament_cmake")
    ci = {".travis.yml": "env:\n  - ROS_DISTRO=eloquent\nscript: colcon build\n"}
    assert (
        plan(tmp_path, {"package.xml": manifest, "CMakeLists.txt": cmake, **ci}, f"date: {day}\n").ros_distro == distro
    )


def test_a_distribution_that_is_newer_than_the_day_is_named(tmp_path: Path) -> None:
    found = plan(tmp_path, ROS1, "date: 2019-01-01\nbase: {ros: dashing}\nkind: ros2\n")
    assert any("ROS dashing was released on 2019-05-31" in warning.message for warning in found.warnings)


def test_a_distribution_of_which_nothing_is_left_is_named(tmp_path: Path) -> None:
    manifest = PACKAGE.replace("catkin", "ament_cmake").replace("roscpp", "rclcpp")
    found = plan(tmp_path, {**ROS1, "package.xml": manifest}, "date: 2019-01-15\nbase: {ros: crystal}\nkind: ros2\n")
    assert found.ros_distro == "dashing"
    said = [warning.message for warning in found.warnings]
    assert "ROS crystal has no official image and no snapshot of its packages: dashing, the next one, is used" in said
    assert any("ROS dashing was released on 2019-05-31" in message for message in said)


def test_inspect_names_what_is_not_of_the_day(tmp_path: Path) -> None:
    plan(tmp_path, PYTHON, "date: 2019-05-20\n")
    planned = plan_repository(tmp_path)
    for said in (inspection_text(planned.decision, planned.plan), inspection_json(planned.decision, planned.plan)):
        assert "the image is to be of 2019-05-20: the base" in said
    files = {"Dockerfile": "FROM ros:melodic\n", "CMakeLists.txt": "project(x)\n"}
    found = plan(tmp_path, files, "dockerfile: Dockerfile\ndate: 2019-05-20\n")
    assert any("Dockerfile is built with the packages of today" in warning.message for warning in found.warnings)


@pytest.mark.parametrize("day", ["2019-02-30", "19-05-20", "yesterday", "2019"])
def test_what_is_no_day(tmp_path: Path, day: str) -> None:
    with pytest.raises(ConfigurationError):
        plan(tmp_path, ROS1, f"date: {day}\n")
