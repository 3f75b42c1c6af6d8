"""A plugin of Gazebo is known by its library, wherever a robot, a world or a launch file loads it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.ros import controllers
from roslab.evidence.ros.gazebo_plugins import read
from roslab.repository.checkout import Repository


def _write(root: Path, files: dict[str, str]) -> Repository:
    for path, text in files.items():
        target = root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    return Repository.open(root)


def test_every_package_is_named_once_where_its_plugin_is_loaded(tmp_path: Path) -> None:
    files = {
        "urdf/robot.xacro": '<robot>\n<!-- <plugin filename="libgazebo_ros_range.so"/> -->\n'
        '<plugin name="c" filename="libgazebo_ros_control.so"/>\n</robot>\n',
        "urdf/wheels.gazebo": '<plugin filename="libgazebo_ros_diff_drive.so"/><plugin filename="libown_wheels.so"/>',
        "worlds/a.world": '<sdf><plugin filename="libgazebo_ros_camera.so"/></sdf>',
        "launch/sim.launch.py": "ExecuteProcess(cmd=['gazebo', '-s', 'libgazebo_ros_init.so'])\n",
        "third_party/x.urdf": '<plugin filename="libgazebo_ros_kobuki.so"/>',
        "README.md": "libgazebo_ros_velodyne_laser.so\n",
    }
    found = [(each.name, each.file, each.line) for each in read(_write(tmp_path, files))]
    assert found == [
        ("gazebo_ros", "launch/sim.launch.py", 1),
        ("gazebo_ros_control", "urdf/robot.xacro", 3),
        ("gazebo_plugins", "urdf/wheels.gazebo", 1),
    ]


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"launch/sim.launch": '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>\n{}'}, True),
        ({"launch/view.launch": "{}"}, False),
        ({"launch/view.launch": "{}", "worlds/a.world": "<sdf/>"}, True),
        ({"launch/sim.launch": "<!-- {} -->", "worlds/a.world": "<sdf/>"}, False),
        ({"urdf/robot.xacro": "{}", "worlds/a.world": "<sdf/>"}, True),
        ({"third_party/launch/sim.launch": "{}", "worlds/a.world": "<sdf/>"}, False),
    ],
)
def test_what_the_robot_of_another_package_loads(tmp_path: Path, files: dict[str, str], *, found: bool) -> None:
    robot = '<param name="r" command="xacro $(find turtlebot3_description)/urdf/turtlebot3_waffle.urdf.xacro"/>'
    repository = _write(tmp_path, {path: text.replace("{}", robot) for path, text in files.items()})
    assert [each.name for each in read(repository)] == (["gazebo_plugins"] if found else [])


def test_the_line_of_such_a_robot_is_that_of_the_file(tmp_path: Path) -> None:
    text = "<launch>\n<!-- " + "the robot " * 20 + "-->\n\n$(find velodyne_description)/urdf/a.xacro\n\n\n</launch>"
    (found,) = read(_write(tmp_path, {"launch/sim.launch": text, "worlds/a.world": "<sdf/>"}))
    assert (found.name, found.file, found.line) == ("velodyne_gazebo_plugins", "launch/sim.launch", 4)


def test_a_plugin_without_the_beginning_and_the_end_of_its_library(tmp_path: Path) -> None:
    plugin = '<plugin\n  filename="gz_ros2_control-system"\n  name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    files = {"urdf/robot.xacro": f"<robot>\n{plugin}\n</plugin>\n</robot>\n", "urdf/b.xacro": '<mesh filename="gz"/>'}
    files["package.xml"] = "<package><name>arm</name><depend>ros_gz_sim</depend></package>"
    assert [(each.name, each.line) for each in read(_write(tmp_path, files))] == [("gz_ros2_control", 3)]


@pytest.mark.parametrize(
    ("path", "text", "found"),
    [
        ("launch/arm.launch", "<launch><node pkg='arm' type='driver' name='driver'/></launch>", False),
        ("launch/arm.launch", "<launch><node pkg='gazebo_ros' type='spawn_model' name='a'/></launch>", True),
        ("launch/arm.launch.py", "Node(package='ros_gz_sim', executable='create')", True),
        ("package.xml", "<package><name>arm</name><exec_depend>gazebo_ros</exec_depend></package>", True),
        ("README.md", "# Arm\nIt can be simulated.\n", True),
        ("README.md", "# Arm\nA driver.\n", False),
        ("worlds/a.world", "<sdf/>", True),
        ("third_party/README.md", "Gazebo\n", False),
    ],
)
def test_a_robot_that_nothing_simulates_needs_no_plugins(tmp_path: Path, path: str, text: str, found: bool) -> None:
    files = {"urdf/arm.urdf": '<plugin name="c" filename="libgazebo_ros_control.so"/>\n', path: text}
    assert bool(read(_write(tmp_path, files))) is found


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("controller_manager:\n  ros__parameters:\n    hand:\n      type: {}\n", "gripper_controllers"),
        ("hand:\n  type: {}\n", "gripper_action_controller"),
        ("hand: {{type: '{}'}}\n", "gripper_action_controller"),
        ("# type: {}\n", None),
    ],
)
def test_a_controller_that_is_called_after_another_package(tmp_path: Path, text: str, found: str | None) -> None:
    files = {"config/a.yaml": text.format("position_controllers/GripperActionController")}
    files["config/b.yaml"] = "type: position_controllers/JointPositionController\n"
    found_here = [each.name for each in controllers.read(_write(tmp_path, files)) if each.namespace == "ros"]
    assert found_here == ([found] if found else [])
