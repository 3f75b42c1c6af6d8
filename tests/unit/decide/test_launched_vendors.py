"""Packages that the default command starts and that only a vendor's own source and hardware bring are told."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Base, Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

PACKAGE = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
LISTS = "project({})\nfind_package(ament_cmake REQUIRED)\n"
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    return LaunchDescription([Node(package='{}', executable='{}')])
"""


@pytest.mark.parametrize(
    ("started", "config", "own", "told"),
    [
        ("nvblox_ros", Config(), (), True),
        ("isaac_ros_visual_slam", Config(), (), True),
        ("zed_wrapper", Config(), (), True),
        ("zed_msgs", Config(), (), False),
        ("rviz2", Config(), (), False),
        ("nvblox_ros", Config(base=Base(image="nvcr.io/nvidia/isaac/ros:humble")), (), False),
        ("nvblox_map", Config(), ("nvblox_map",), False),  # the tree's own
    ],
)
def test_what_needs_the_source_of_a_vendor_is_told(
    tmp_path: Path, started: str, config: Config, own: tuple[str, ...], *, told: bool
) -> None:
    files = {"README.md": "Runs on ROS 2 Humble.\n```\nros2 launch arm run.launch.py\n```\n"}
    for name in ("arm", *own):
        files |= {f"{name}/package.xml": PACKAGE.format(name), f"{name}/CMakeLists.txt": LISTS.format(name)}
    files["arm/launch/run.launch.py"] = LAUNCH.format(started, started)
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    decision = decide(gather(Repository.open(tmp_path)), config, folder_name="demo")
    found = [(each.file, each.line) for each in decision.warnings if f"starts {started}, which needs" in each.message]
    assert found == ([("arm/launch/run.launch.py", 4)] if told else [])


@pytest.mark.parametrize(("key", "guessed"), [("zed_wrapper", False), ("odd_wrapper", True)])
def test_what_a_vendor_has_is_not_guessed_at_the_owner_s(tmp_path: Path, key: str, *, guessed: bool) -> None:
    files = {
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/arm\n',
        ".git/HEAD": "ref: refs/heads/a\n",
        "README.md": "Runs on ROS 2 Humble.\n",
        "package.xml": PACKAGE.format("arm").replace("</package>", f"<depend>{key}</depend></package>"),
        "CMakeLists.txt": LISTS.format("arm"),
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    told = [each.message for each in decision.warnings if each.message.startswith(f"rosdep has no key {key}")]
    assert len(told) == 1
    assert ("https://github.com/lab/" in told[0]) is guessed
    assert ("the ZED SDK" in told[0] and "stereolabs.com" in told[0]) is not guessed
