"""Data that a package of ROS needs and does not bring, and the tool of a workspace that the base does not have."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile

PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend>{more}</package>"
MADE = "project(demo)\nfind_package(catkin REQUIRED)\n"


def planned(folder: Path, more: str = "", page: str = "ROS Noetic\n") -> Plan:
    files = {"package.xml": PACKAGE.format(more=more), "CMakeLists.txt": MADE, "README.md": page}
    for path, text in files.items():
        (folder / path).write_text(text, encoding="utf-8")
    return plan_repository(folder).plan


@pytest.mark.parametrize(
    ("more", "page"),
    [
        ("<run_depend>mavros</run_depend>", "ROS Noetic\n"),
        ("", "ROS Noetic\n```\nsudo apt install ros-noetic-mavros\n```\n"),
    ],
)
def test_the_data_are_fetched_after_the_package(tmp_path: Path, more: str, page: str) -> None:
    plan = planned(tmp_path, more, page)
    assert "wget" in plan.apt_tools
    text = dockerfile(plan)
    run = "if [ -x /opt/ros/noetic/lib/mavros/install_geographiclib_datasets.sh ]; then"
    assert text.index("install-rosdep-keys --tables") < text.index(run) < text.index("catkin_make -j")


def test_messages_alone_need_no_data(tmp_path: Path) -> None:
    plan = planned(tmp_path, "<run_depend>mavros_msgs</run_depend>")
    assert not plan.package_data
    assert "wget" not in plan.apt_tools


def test_what_is_cloned_may_fetch_its_library(tmp_path: Path) -> None:
    plan = planned(tmp_path, "<depend>glog_catkin</depend><run_depend>mavros</run_depend>")
    assert plan.apt_tools.count("wget") == 1
    assert "wget" in planned(tmp_path, "<depend>glog_catkin</depend>").apt_tools


def test_colcon_is_installed_for_ros_1(tmp_path: Path) -> None:
    plan = planned(tmp_path, page="ROS Noetic\n```\ncolcon build\n```\n")
    assert plan.workspace.ros
    assert plan.workspace.ros.tool == "colcon"
    assert "python3-colcon-common-extensions" in plan.apt_tools


@pytest.mark.parametrize("ros", ["Melodic", "Noetic"])
@pytest.mark.parametrize("name", ["python-catkin-tools", "python3-catkin-tools"])
def test_a_tool_of_the_workspace_is_asked_for_once(tmp_path: Path, ros: str, name: str) -> None:
    page = f"ROS {ros}\n```\nsudo apt install {name} python-foo\ncatkin build\n```\n"
    plan = planned(tmp_path, page=page)
    tool = "python-catkin-tools" if ros == "Melodic" else "python3-catkin-tools"
    assert plan.apt_tools == (tool,)
    # Ubuntu 18.04 may have the other one from elsewhere; a newer one has no tool for Python 2
    left = {name} if (ros, name) == ("Melodic", "python3-catkin-tools") else set()
    assert {*plan.apt_guessed} == {"python-foo", *left}
