"""The hardware of ros2_control that a robot description loads is brought, where the distribution has it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": '<package format="3"><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "project(arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
    "README.md": "ROS 2 Humble\n",
}
SYSTEM = '<ros2_control name="a" type="system">{}</ros2_control>'


def _hardware(name: str) -> str:
    return SYSTEM.format(f"<hardware>\n<plugin>{name}</plugin>\n</hardware>")


@pytest.mark.parametrize(
    ("text", "brought"),
    [
        (_hardware("gazebo_ros2_control/GazeboSystem"), "ros-humble-gazebo-ros2-control"),
        (_hardware(" ur_robot_driver/URPositionHardwareInterface "), "ros-humble-ur-robot-driver"),
        (_hardware("mock_components/GenericSystem"), "ros-humble-hardware-interface"),
        (_hardware("fake_components/GenericSystem"), "ros-humble-hardware-interface"),
        (
            SYSTEM.format(
                '<hardware>\n<xacro:if value="$(arg sim)"><plugin>gz_ros2_control/GazeboSimSystem</plugin></xacro:if>\n'
                "</hardware>"
            ),
            "ros-humble-gz-ros2-control",
        ),
        (f"<!-- {_hardware('gazebo_ros2_control/GazeboSystem')} -->", ""),
        (_hardware("acme_hardware/AcmeSystem"), ""),
        (_hardware("arm/ArmSystem"), ""),
        (_hardware("acme::AcmeSystem"), ""),
        ("<gazebo><plugin>gazebo_ros2_control/GazeboSystem</plugin></gazebo>", ""),
        (f"{SYSTEM.format('<hardware/>')}<plugin>gazebo_ros2_control/GazeboSystem</plugin>", ""),
    ],
)
def test_hardware_of_the_distribution(tree: Tree, text: str, brought: str) -> None:
    decision = tree({**PACKAGE, "urdf/arm.ros2_control.xacro": f"<robot>{text}</robot>"})
    named = {*decision.apt, *decision.apt_guessed} - {"ros-humble-ros-base"}
    assert {each for each in named if each.startswith("ros-humble-")} == ({brought} if brought else set())
    assert not [each for each in decision.warnings if "acme" in each.message]
