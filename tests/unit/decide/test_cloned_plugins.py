"""A plugin of Gazebo or a controller that the tree's files name asks for the clone that brings it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
PLUGIN = '<robot name="a"><plugin filename="libroboticsgroup_upatras_gazebo_mimic_joint_plugin.so" name="b"/></robot>\n'
GRIPPER = "gripper:\n  type: position_controllers/GazeboGripperActionController\n"
PLUGINS, CONTROLLER = "roboticsgroup_upatras_gazebo_plugins", "gazebo_gripper_action_controller"


@pytest.mark.parametrize(
    ("files", "cloned"),
    [
        ({"urdf/arm.xacro": PLUGIN}, {PLUGINS}),
        ({"config/arm.yaml": GRIPPER}, {CONTROLLER}),
        ({"config/arm.yaml": GRIPPER, "a/package.xml": PACKAGE.format(CONTROLLER)}, set()),
        ({"config/arm.yaml": GRIPPER.replace("Gazebo", "")}, set()),
    ],
    ids=["plugin", "controller", "own", "released"],
)
def test_what_a_dockerfile_clones_is_cloned(tree: Tree, files: dict[str, str], cloned: set[str]) -> None:
    clones = "".join(f"RUN git clone https://github.com/lab/{name}.git src/{name}\n" for name in (PLUGINS, CONTROLLER))
    authored = {
        "Dockerfile": f"FROM lab/noetic:latest\nRUN git clone https://github.com/lab/demo.git src/demo\n{clones}"
    }
    own = {"demo/package.xml": PACKAGE.format("demo"), "README.md": "ROS Noetic\n"}
    decision = tree({**authored, **own, **files})
    assert {source.name for source in decision.source} == cloned
