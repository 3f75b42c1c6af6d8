"""The packages of the plugins that parameter files name, and of those that layouts of rqt open."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.ros import launch, plugin_types, plugins
from roslab.repository.checkout import Repository


def of(text: str) -> list[str]:
    return [name for name, _ in plugin_types.named(text)]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ('FollowPath:\n  plugin: "nav2_mppi_controller::MPPIController"\n', ["nav2_mppi_controller"]),
        ('  primary_controller: "dwb_core::DWBLocalPlanner"\n', ["dwb_core"]),
        ("solver_plugin: solver_plugins::CeresSolver\n", ["slam_toolbox"]),
        ("kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n", ["moveit_kinematics"]),
        ("planning_plugin: ompl_interface/OMPLPlanner\n", ["moveit_planners_ompl"]),
        ("  - sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater\n", ["moveit_ros_perception"]),
        ("  RRT:\n    type: geometric::RRT\n", []),  # a planner of OMPL, no package
        ("- name: inpaint\n  type: gridMapCv/InpaintFilter\n", ["grid_map_cv"]),
        ("type: someThing/Filter\n", []),  # no package has capitals
        ('planner_plugin_types: ["nav2_navfn_planner/NavfnPlanner", "own::Planner"]\n', ["nav2_navfn_planner", "own"]),
        ("planning_plugins:\n  - ompl_interface/OMPLPlanner\n  # - chomp_interface/CHOMPPlanner\nother: x\n  - a/B\n", ["moveit_planners_ompl"]),  # noqa: E501
        ("request_adapters: >-\n  default_planner_request_adapters/FixWorkspaceBounds\n  default_planner_request_adapters/FixStartStateBounds\n", ["moveit_ros_planning"] * 2),  # noqa: E501
        ("potential_calculator: dlux_plugins::AStar\n", ["dlux_plugins"]),
        ("critics: [RotateToGoal, a/B]\n# plugin: a/B\nx: a/B\n", []),
        ("type: sensor_msgs/msg/Image\ntype: package://own/Mesh.stl\nplugin: file/Name.so\n", []),
    ],
)  # fmt: skip
def test_the_packages_of_named_plugins(text: str, found: list[str]) -> None:
    assert of(text) == found


def test_a_plugin_has_the_line_of_its_name(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text("planning_plugins:\n  - ompl_interface/OMPLPlanner\n  - pilz/CommandPlanner\n")
    found = plugins.read(Repository.open(tmp_path))
    assert [(each.name, each.line) for each in found] == [
        ("moveit_planners_ompl", 2),
        ("pilz_trajectory_generation", 3),
    ]


@pytest.mark.parametrize(
    ("planner", "loaded"),
    [
        ("dwb_local_planner::DWBLocalPlanner", ["dwb_local_planner", "dwb_critics", "dwb_plugins"]),
        ("dlux_global_planner::DluxGlobalPlanner", ["dlux_global_planner", "dlux_plugins"]),
    ],
)
def test_planners_of_ros_1_load_others_by_default(tmp_path: Path, planner: str, loaded: list[str]) -> None:
    (tmp_path / "a.yaml").write_text(f"LocalPlannerAdapter:\n  planner_name: {planner}\n")
    assert [each.name for each in plugins.read(Repository.open(tmp_path))] == loaded


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ('<param name="planning_plugin" value="ompl_interface/OMPLPlanner"/>', "moveit_planners_ompl"),
        ('<param name="base_local_planner" value="teb_local_planner/TebLocalPlannerROS"/>', "teb_local_planner"),
        ("<rosparam>\nkinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n</rosparam>", "moveit_kinematics"),
    ],
)
def test_launch_files_name_plugins_too(tmp_path: Path, line: str, found: str) -> None:
    (tmp_path / "a.launch").write_text(f"<launch>\n{line}\n</launch>\n")
    (file,) = launch.read(Repository.open(tmp_path))
    assert [each.name for each in file.dependencies] == [found]


LAYOUT = """{
  "keys": {},
  "groups": {
    "pluginmanager": {
      "keys": {
        "running-plugins": {
          "type": "repr",
          "repr": "{u'rqt_image_view/ImageView': [1, 2], u'own_plugin/Test Suite - Climbing': [1], 'rqt_bag/Bag': []}"
        }
      },
      "groups": {"plugin__rqt_rviz__RViz__1": {"keys": {"x": {"repr": "u'rqt_rviz/RViz': [1]"}}}}
    }
  }
}
"""


def test_a_layout_of_rqt_asks_for_the_plugins_that_are_open_in_it(tmp_path: Path) -> None:
    (tmp_path / "viewers.perspective").write_text(LAYOUT)
    found = plugins.read(Repository.open(tmp_path))
    assert [(each.name, each.line, each.role) for each in found] == [
        ("rqt_gui", 8, "exec"),
        ("rqt_image_view", 8, "exec"),
        ("own_plugin", 8, "exec"),
    ]


def test_layouts_of_vendored_code_and_without_open_plugins_ask_for_nothing(tmp_path: Path) -> None:
    (tmp_path / "third_party").mkdir()
    (tmp_path / "third_party" / "a.perspective").write_text(LAYOUT)
    (tmp_path / "b.perspective").write_text(LAYOUT.replace("running-plugins", "others"))
    assert plugins.read(Repository.open(tmp_path)) == ()
