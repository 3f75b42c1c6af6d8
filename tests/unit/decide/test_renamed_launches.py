"""A launch file of the tree takes the place of one of a package that exists nowhere."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LAUNCH = (
    "from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument\n"
    "def generate_launch_description():\n    return LaunchDescription([DeclareLaunchArgument(\n"
    "        'mode', default_value='imu')])\n"
)
PACKAGE = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
CMAKE = "project({})\nfind_package(ament_cmake REQUIRED)\ninstall(DIRECTORY launch DESTINATION share)\n"


def made(*files: str, said: str) -> dict[str, str]:
    page = f"# Demo\n## Run\n```\nros2 launch {said}\n```\n"
    found = {"README.md": page, "package.xml": PACKAGE.format("edf"), "CMakeLists.txt": CMAKE.format("edf")}
    return found | {f"launch/{file}": LAUNCH for file in files}


@pytest.mark.parametrize(
    ("files", "said", "command"),
    [
        (("lidar_localization.launch.py", "map.launch.py"), "localization localization.launch.py mode:=gps",
         "edf lidar_localization.launch.py mode:=gps"),
        (("localization.launch.py", "lidar_localization.launch.py"), "localization localization.launch.py",
         "edf localization.launch.py"),
        (("localization_only.launch.py", "map.launch.py"), "robo_stack localization.launch.py",
         "edf localization_only.launch.py"),
    ],
)  # fmt: skip
def test_the_one_that_is_meant_is_taken_and_told(tree: Tree, files: tuple[str, ...], said: str, command: str) -> None:
    decision = tree(made(*files, said=said))
    assert " ".join(decision.command[2:]) == command
    name, _, _ = said.partition(" ")
    taken = " ".join(command.split()[:2])
    told = f"the README launches from {name}, and no package is called so: {taken} is taken"
    assert [w.message for w in decision.warnings if "README" in w.message] == [told]


@pytest.mark.parametrize(
    ("files", "said"),
    [
        (("a_localization.launch.py", "b_localization.launch.py"), "localization localization.launch.py"),
        (("lidar_localization.launch.py", "map.launch.py"), "localization localization.launch.py other:=1"),
        (("slam.launch.py", "map.launch.py"), "localization localization.launch.py"),
    ],
)
def test_nothing_is_taken_where_it_is_not_clear(tree: Tree, files: tuple[str, ...], said: str) -> None:
    decision = tree(made(*files, said=said))
    assert decision.command == ("bash",)
    assert any("nothing is known to bring a package of that name" in w.message for w in decision.warnings)


def test_of_several_packages_none_is_taken(tree: Tree) -> None:
    other = {
        "b/package.xml": PACKAGE.format("b"),
        "b/CMakeLists.txt": CMAKE.format("b"),
        "b/launch/c.launch.py": LAUNCH,
    }
    files = made("lidar_localization.launch.py", said="localization localization.launch.py")
    files = {name if name == "README.md" else f"a/{name}": text for name, text in files.items()}
    assert tree(files | other).command == ("bash",)
