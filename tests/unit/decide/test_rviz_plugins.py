"""Plugins of rviz that a configuration names which a launch file loads: their packages are in the image."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = (
    "<package format='2'><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>rviz</depend></package>"
)
SHOWN = "Panels:\n  - Class: rviz/Displays\nVisualization Manager:\n  Displays:\n    - Alpha: 0.5\n      Class: {}\n"
START = '<node pkg="rviz" type="rviz" name="a" args="-d $(find demo)/rviz/{}.rviz" {}/>'


def launched(tree: Tree, name: str, start: str = START.format("a", ""), more: str = "") -> Decision:
    files = {
        "demo/package.xml": PACKAGE,
        "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "demo/launch/demo.launch": f"<launch>{start}</launch>",
        "demo/rviz/a.rviz": SHOWN.format(name),
        "README.md": f"ROS Noetic\n```\n{more}catkin_make\nroslaunch demo demo.launch\n```\n",
    }
    return tree(files)


def installed(decision: Decision) -> tuple[str, ...]:
    return (*decision.apt, *decision.apt_guessed)


@pytest.mark.parametrize(
    ("name", "package"),
    [
        ("grid_map_rviz_plugin/GridMap", "grid-map-rviz-plugin"),
        ("jsk_rviz_plugin/BoundingBoxArray", "jsk-rviz-plugins"),
        ("moveit_rviz_plugin/MotionPlanning", "moveit-ros-visualization"),
        ("slam_toolbox::SlamToolboxPlugin", "slam-toolbox"),
        ('"rtabmap_rviz_plugins/MapCloud"', "rtabmap-rviz-plugins"),
        ("rviz/Grid", ""),
        ("rviz_default_plugins/Grid", ""),
        ("nav2_rviz_plugins/Navigation", ""),  # of ROS 2 alone
        ("Submaps", ""),
    ],
)
def test_the_package_of_a_plugin_is_installed(tree: Tree, name: str, package: str) -> None:
    found = [each for each in installed(launched(tree, name)) if each.startswith("ros-noetic-")]
    assert found == ([f"ros-noetic-{package}"] if package else [])


@pytest.mark.parametrize("start", [START.format("b", ""), START.format("a", 'if="$(arg rviz)"')])
def test_what_is_not_loaded_or_waits_for_an_argument_brings_none(tree: Tree, start: str) -> None:
    assert not any("grid-map" in each for each in installed(launched(tree, "grid_map_rviz_plugin/GridMap", start)))


def test_what_nothing_brings_is_told_and_stops_nothing(tree: Tree) -> None:
    decision = launched(tree, "acme_rviz_plugins/Cloud")
    (said,) = [each for each in decision.warnings if "acme_rviz_plugins" in each.message]
    assert "it shows errors in their places" in said.message
    assert (said.file, said.line) == ("demo/rviz/a.rviz", 6)
    cloned = launched(tree, "acme_rviz_plugins/Cloud", more="cd src\ngit clone https://github.com/lab/acme\n")
    assert not any("acme_rviz_plugins" in each.message for each in cloned.warnings)
