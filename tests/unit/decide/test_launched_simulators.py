"""A simulator that the default command's launch file starts by a module: no package of ROS brings Webots."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
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


FILE = "https://github.com/cyberbotics/webots/releases/download/R2025a/webots_2025a_amd64.deb"
FETCHED = "wget https://github.com/lab/webots/releases/download/R2023b/webots_2023b_amd64.deb\n"
FETCHED += "sudo apt install ./webots_2023b_amd64.deb\n"


def _decided(tmp_path: Path, started: str, config: Config, *, distro: str, before: str = "") -> Decision:
    other = WEBOTS.replace("webots_ros2_driver.webots_launcher", "arm.launcher")
    launches = {"launch/sim.launch.py": WEBOTS, "launch/all.launch.py": ABOVE, "launch/other.launch.py": other}
    page = f"ROS 2 {distro}\n```\n{before}ros2 launch arm {started}.launch.py\n```\n"
    for path, text in {**PACKAGE, **launches, "README.md": page}.items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    decision = decide(gather(Repository.open(tmp_path)), config, folder_name="arm")
    assert (decision.command, decision.ros_distro) == (
        ("ros2", "launch", "arm", f"{started}.launch.py"),
        distro.lower(),
    )
    return decision


CASES = [
    ("sim", Config(), True),
    ("all", Config(), True),
    ("other", Config(), False),
    ("sim", Config(env=(("WEBOTS_HOME", "/opt/webots"),)), False),
    ("sim", Config(apt=("webots",)), False),
]


@pytest.mark.parametrize(("started", "config", "brought"), CASES)
def test_webots_is_installed_by_its_file(tmp_path: Path, started: str, config: Config, brought: bool) -> None:
    decision = _decided(tmp_path, started, config, distro="Humble")
    assert decision.own_packages == ((FILE,) if brought else ())
    assert (("WEBOTS_HOME", "/usr/local/webots") in decision.variables) is brought
    found = [(each.file, each.line) for each in decision.warnings if "Webots" in each.message]
    assert found == ([("launch/sim.launch.py", 2)] if brought else [])
    assert not any("the simulator Webots" in each.message for each in decision.warnings)


@pytest.mark.parametrize(("started", "config", "told"), CASES)
def test_webots_is_told_where_no_release_is_known(tmp_path: Path, started: str, config: Config, told: bool) -> None:
    decision = _decided(tmp_path, started, config, distro="Foxy")
    assert not decision.own_packages
    found = [(each.file, each.line) for each in decision.warnings if "the simulator Webots" in each.message]
    assert found == ([("launch/sim.launch.py", 2)] if told else [])


@pytest.mark.parametrize("distro", ["Humble", "Foxy"])
def test_the_package_of_the_page_is_taken(tmp_path: Path, distro: str) -> None:
    decision = _decided(tmp_path, "sim", Config(), distro=distro, before=FETCHED)
    assert [each.rpartition("/")[2] for each in decision.own_packages] == ["webots_2023b_amd64.deb"]
    assert not any("the simulator Webots" in each.message for each in decision.warnings)


def test_that_it_is_for_amd64_alone_is_told_where_the_image_is_for_others_too(tmp_path: Path) -> None:
    decision = _decided(tmp_path, "sim", Config(platforms=("linux/amd64",)), distro="Humble")
    assert decision.own_packages == (FILE,)
    assert not any("Webots" in each.message for each in decision.warnings)
