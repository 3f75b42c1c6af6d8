"""A launch file that includes one of Gazebo's own opens its window, unless it says otherwise."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.ros import launch
from roslab.repository.checkout import Repository

WORLD = '<include file="$(find gazebo_ros)/launch/empty_world.launch"'
GIVEN = f'{WORLD}>\n<arg name="world_name" value="a.world"/>\n<arg name="gui" value="$(arg gui)"/>\n</include>'
PYTHON = """\
from launch import LaunchDescription
def generate_launch_description():
    there = get_package_share_directory('gazebo_ros')
    world = os.path.join(there, 'launch', 'gazebo.launch.py')
    source = PythonLaunchDescriptionSource(world)
    return LaunchDescription([IncludeLaunchDescription(source{})])
"""


def opens(tmp_path: Path, name: str, text: str) -> bool:
    (tmp_path / name).write_text(text)
    (found,) = launch.read(Repository.open(tmp_path))
    return found.gui


@pytest.mark.parametrize(
    ("text", "window"),
    [
        (f"{WORLD}/>", True),
        (f'<arg name="gui" default="true"/>{GIVEN}', True),
        (f'<arg name="gui" default="false"/>{GIVEN}', False),
        (f'<arg name="gui" value="$(arg shown)"/><arg name="shown" default="False"/>{GIVEN}', False),
        (
            f'<include file="a.launch"><arg name="gui" value="false"/></include><arg name="gui" default="1"/>{GIVEN}',
            True,
        ),
        (GIVEN.replace("$(arg gui)", "0"), False),
        (f'{WORLD} if="$(arg simulated)"/>', False),
        (f"<!-- {WORLD}/> -->", False),
        (f'<node pkg="gazebo_ros" type="spawn_model" name="a"/>{WORLD.replace("gazebo_ros", "own")}/>', False),
    ],
)
def test_of_ros_1(tmp_path: Path, text: str, *, window: bool) -> None:
    assert opens(tmp_path, "a.launch", f"<launch>\n{text}\n</launch>\n") is window


@pytest.mark.parametrize(
    ("given", "window"),
    [
        ("", True),
        (", launch_arguments={'gui': 'false'}.items()", False),
        (", condition=IfCondition(LaunchConfiguration('gui'))", False),
    ],
)
def test_of_ros_2(tmp_path: Path, given: str, *, window: bool) -> None:
    assert opens(tmp_path, "a.launch.py", PYTHON.format(given)) is window
