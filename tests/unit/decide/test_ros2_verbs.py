"""Commands of ros2 that launch files and scripts call and a base does not have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

_CONTROL = '["ros2", "control", "load_controller", "arm"]'


@pytest.mark.parametrize(
    ("path", "text", "found"),
    [
        ("launch/a.launch.py", f"ExecuteProcess(cmd={_CONTROL})\n", ["ros-humble-ros2controlcli"]),
        (
            "launch/a.launch.py",
            "ExecuteProcess(cmd=[\n    'ros2',\n    'control',\n    'list'])\n",
            ["ros-humble-ros2controlcli"],
        ),
        ("launch/a.launch.py", "ExecuteProcess(cmd=['ros2 bag play a'], shell=True)\n", ["ros-humble-ros2bag"]),
        (
            "launch/a.launch.xml",
            '<launch><executable cmd="ros2 control list"/></launch>\n',
            ["ros-humble-ros2controlcli"],
        ),
        ("run.sh", "ros2 bag record -a\n", ["ros-humble-ros2bag"]),
        ("launch/a.launch.py", f"# ExecuteProcess(cmd={_CONTROL})\n", []),
        ("launch/a.launch.py", "ExecuteProcess(cmd=['ros2', 'topic', 'pub', '/a'])\n", []),
        ("launch/a.launch.py", "LogInfo(msg='see ros2 control list')\n", []),
        ("run.sh", "echo 'now: ros2 bag record -a'\n", []),
        ("run.sh", "my_ros2 bag record -a\n", []),
    ],
)
def test_the_package_of_a_command(tree: Tree, path: str, text: str, found: list[str]) -> None:
    files = {
        "package.xml": '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
        "<export><build_type>ament_cmake</build_type></export></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "README.md": "For ROS Humble.\n",
        path: text,
    }
    assert [name for name in tree(files).apt_guessed if "ros2" in name] == found


def test_ros_1_has_none(tree: Tree) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "README.md": "For ROS Noetic.\n",
        "run.sh": "ros2 bag record -a\n",
    }
    assert not [name for name in tree(files).apt_guessed if "bag" in name]
