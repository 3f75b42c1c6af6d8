"""A simulator that the default command's launch file starts by a module is told: no package of ROS brings Webots."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

PACKAGE = {
    "package.xml": "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(arm)\nfind_package(ament_cmake REQUIRED)\n",
}
WEBOTS = """\
from launch import LaunchDescription
from webots_ros2_driver.webots_launcher import WebotsLauncher
def generate_launch_description():
    return LaunchDescription([WebotsLauncher(world='a.wbt')])
"""
ABOVE = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
def generate_launch_description():
    below = os.path.join(get_package_share_directory('arm'), 'launch', 'sim.launch.py')
    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource(below))])
"""


@pytest.mark.parametrize(
    ("started", "config", "told"),
    [
        ("sim", Config(), True),
        ("all", Config(), True),
        ("other", Config(), False),
        ("sim", Config(env=(("WEBOTS_HOME", "/opt/webots"),)), False),
        ("sim", Config(apt=("webots",)), False),
    ],
)
def test_webots_is_told(tmp_path: Path, started: str, config: Config, told: bool) -> None:
    other = WEBOTS.replace("webots_ros2_driver.webots_launcher", "arm.launcher")
    launches = {"launch/sim.launch.py": WEBOTS, "launch/all.launch.py": ABOVE, "launch/other.launch.py": other}
    for path, text in {**PACKAGE, **launches, "README.md": f"```\nros2 launch arm {started}.launch.py\n```\n"}.items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    decision = decide(gather(Repository.open(tmp_path)), config, folder_name="arm")
    assert decision.command == ("ros2", "launch", "arm", f"{started}.launch.py")
    found = [(each.file, each.line) for each in decision.warnings if "the simulator Webots" in each.message]
    assert found == ([("launch/sim.launch.py", 2)] if told else [])
