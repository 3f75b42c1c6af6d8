"""Commands of ros2 that launch files and scripts call and a base does not have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from trees import HUMBLE, NOETIC

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
    assert [name for name in tree(HUMBLE | {path: text}).apt_guessed if "ros2" in name] == found


def test_ros_1_has_none(tree: Tree) -> None:
    assert not [name for name in tree(NOETIC | {"run.sh": "ros2 bag record -a\n"}).apt_guessed if "bag" in name]
