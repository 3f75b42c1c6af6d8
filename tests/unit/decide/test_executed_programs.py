"""Programs that the launch file of the default command starts beside its nodes are installed, or told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
XML = (
    "<package><name>drone</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
CMAKE = "project(drone)\nfind_package(ament_cmake REQUIRED)\nadd_executable(bridge src/bridge.cpp)\n"
LAUNCH = (
    "from launch import LaunchDescription\n{}\ndef generate_launch_description():\n    return LaunchDescription([{}])\n"
)


def of(tree: Tree, action: str, before: str = "") -> Decision:
    files = {"package.xml": XML, "CMakeLists.txt": CMAKE, "src/bridge.cpp": "int main() {}\n"}
    files["launch/sim.launch.py"] = LAUNCH.format(before, action)
    return tree(files | {"README.md": "For ROS 2 Humble.\n# Run\n```\nros2 launch drone sim.launch.py\n```\n"})


@pytest.mark.parametrize(
    ("action", "program"),
    [
        ("ExecuteProcess(cmd=['MicroXRCEAgent', 'udp4'])", "MicroXRCEAgent"),
        ("ExecuteProcess(\n    output='screen',\n    cmd=[\n        'sudo MicroXRCEAgent udp4'])", "MicroXRCEAgent"),
        ("ExecuteProcess(cmd=agent)", "MicroXRCEAgent"),
        ("ExecuteProcess(cmd=other)", None),
        ("ExecuteProcess(cmd=[path, 'MicroXRCEAgent'])", None),
        ("ExecuteProcess(cmd=['/usr/bin/MicroXRCEAgent'])", None),
        ("ExecuteProcess(cmd=['ros2', 'bag', 'play'])", None),
        ("ExecuteProcess(cmd=['gzserver', 'a.world'])", None),
        ("ExecuteProcess(cmd=['bash', '-c', 'true'])", None),
        ("ExecuteProcess(cmd=['bridge'])", None),
        ("# ExecuteProcess(cmd=['MicroXRCEAgent'])\n", None),
    ],
)
def test_a_program_that_nothing_brings_is_told(tree: Tree, action: str, program: str | None) -> None:
    decision = of(tree, action, "agent = ['MicroXRCEAgent', 'udp4']\n")
    told = [each.message for each in decision.warnings if "starts the program" in each.message]
    what = f"the default command starts the program {program}, which nothing is known to bring"
    assert told == (
        [f"{what}: bring it from https://github.com/eProsima/Micro-XRCE-DDS-Agent by `custom` in roslab.yaml"]
        if program
        else []
    )


def test_a_program_of_a_package_is_installed(tree: Tree) -> None:
    decision = of(tree, "ExecuteProcess(cmd=['socat', '-d'])")
    assert "socat" in (*decision.apt, *decision.apt_guessed)
    assert not any("socat" in each.message for each in decision.warnings)


def test_python_is_that_of_ros(tree: Tree) -> None:
    decision = of(tree, "ExecuteProcess(cmd=['python3', 'a.py'])")
    assert "python3" not in (*decision.apt, *decision.apt_guessed)


def test_the_folder_of_an_author_is_told(tree: Tree) -> None:
    action = "ExecuteProcess(cmd=['make', 'sitl'], cwd=os.path.expanduser('~/PX4-Autopilot'), output='screen')"
    told = [each.message for each in of(tree, action).warnings if "PX4" in each.message]
    where = "the default command starts make in ~/PX4-Autopilot, a folder of the author's computer"
    assert told == [f"{where}: bring what is in it by `custom` in roslab.yaml, or set `command`"]


def test_a_condition_that_does_not_hold_starts_nothing(tree: Tree) -> None:
    off = "DeclareLaunchArgument('sim', default_value='false'), "
    action = "ExecuteProcess(condition=IfCondition(LaunchConfiguration('sim')), cmd=['MicroXRCEAgent'])"
    assert not any("MicroXRCE" in each.message for each in of(tree, off + action).warnings)
