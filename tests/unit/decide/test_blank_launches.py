"""A launch file that a page names with a blank is one of those that fit."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.blank_launches import with_a_launch_file
from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "launch/mapping_velodyne.launch": "<launch/>\n",
    "launch/mapping_ouster.launch": "<launch/>\n",
    "launch/show.launch": "<launch/>\n",
}


@pytest.mark.parametrize(
    ("said", "file"),
    [
        ("mapping_XXX.launch out_path:=/your/path", "mapping_ouster.launch"),
        ("mapping_SENSOR_NAME.launch rviz:=false", "mapping_ouster.launch"),
        ("XXX_velodyne.launch", "mapping_velodyne.launch"),
        ("mapping_[xxx_sensor].launch", "mapping_ouster.launch"),
        ("mapping_<sensor>.launch rviz:=false", "mapping_ouster.launch"),
        ("mapping_{sensor name}.launch", "show.launch"),  # two words for a shell
        ("mapping_{sensor}.launch", "mapping_ouster.launch"),
        ("[sensor].launch", "show.launch"),
        ("mapping_velodyne.launch", "mapping_velodyne.launch"),
        ("XXX.launch", "show.launch"),
        ("localize_XXX.launch", "show.launch"),
    ],
)
def test_the_first_that_fits_is_started(tree: Tree, said: str, file: str) -> None:
    page = f"ROS Noetic\n```\nroslaunch demo {said}\n```\nAnd then\n```\nroslaunch demo show.launch\n```\n"
    command = tree({**FILES, "README.md": page}).command
    assert command[:3] == ("roslaunch", "demo", file)
    assert ("rviz:=false" in command) == ("rviz" in said)


@pytest.mark.parametrize(
    ("blank", "above", "file"),
    [
        ("[launch-file]", "# Use\n| Desk | [a](launch/mapping_velodyne.launch) |", "mapping_velodyne.launch"),
        (
            "<launch file>",
            "# Use\nOf launch/mapping_ouster.launch and mapping_velodyne.launch.",
            "mapping_ouster.launch",
        ),
        ("mapping_[x].launch", "# Use\n| Desk | [a](launch/mapping_velodyne.launch) |", "mapping_velodyne.launch"),
        ("mapping_[x].launch", "# Use\n| Desk | [a](launch/show.launch) |", "mapping_ouster.launch"),
        ("[launch-file]", "# Build\nSee launch/mapping_velodyne.launch.\n# Use", "show.launch"),
        ("[launch-file]", "# Use\nNothing is named here.", "show.launch"),
    ],
)
def test_a_launch_file_that_is_a_blank_is_the_first_that_its_section_names(
    tree: Tree, blank: str, above: str, file: str
) -> None:
    run = f"```\nroslaunch demo {blank} auto:=true\n```\n"
    page = f"Of ROS Noetic\n\n{above}\n\n{run}\nLive:\n```\nroslaunch demo show.launch\n```\n"
    command = tree({**FILES, "README.md": page}).command
    assert command[:3] == ("roslaunch", "demo", file)
    assert ("auto:=true" in command) == (file != "show.launch")


TO_FILL = (
    '<launch><rosparam command="load" file="[PATH_TO_CONFIG]/a.yaml"/><node pkg="demo" type="a" name="a"/></launch>\n'
)
PLAIN = TO_FILL.replace("[PATH_TO_CONFIG]", "$(find demo)")


@pytest.mark.parametrize("page", ["Write one like [this](launch/own.launch).", "# Use\nlaunch/own.launch", ""])
@pytest.mark.parametrize(
    ("text", "file"),
    [
        (TO_FILL, "show.launch"),
        (TO_FILL.replace("[PATH_TO_CONFIG]", "/path/to"), "show.launch"),
        (TO_FILL.replace('command="load"', 'if="$(arg x)"'), "own.launch"),
        (PLAIN, "own.launch"),
        (TO_FILL.replace("[PATH_TO_CONFIG]/a", "$(find demo)/config/path_to_goal"), "own.launch"),
        (TO_FILL.replace("[PATH_TO_CONFIG]", "path_to_config"), "show.launch"),
    ],
    ids=["blank", "path", "condition", "filled", "named so", "path of one word"],
)
def test_one_that_is_to_be_filled_in_is_not_started(tree: Tree, page: str, text: str, file: str) -> None:
    files = {name: said for name, said in FILES.items() if "mapping" not in name} | {"launch/own.launch": text}
    files["launch/show.launch"] = '<launch><node pkg="demo" type="b" name="b"/></launch>\n'
    command = tree({**files, "README.md": f"ROS Noetic\n\n{page}\n"}).command
    assert command == ("roslaunch", "demo", file) if page or file == "show.launch" else command == ("bash",)


def test_one_that_a_page_starts_all_the_same_is_told(tree: Tree) -> None:
    files = {**FILES, "launch/own.launch": TO_FILL, "README.md": "ROS Noetic\n```\nroslaunch demo own.launch\n```\n"}
    decision = tree(files)
    assert decision.command == ("roslaunch", "demo", "own.launch")
    (told,) = [each for each in decision.warnings if "of his own" in each.message]
    assert (told.file, told.line) == ("launch/own.launch", 1)


LAUNCHED = (
    "from better_launch import BetterLaunch, launch_this\n\n@launch_this\ndef main(\n    real: bool = False,\n):\n"
)
LAUNCHED += (
    '    bl = BetterLaunch()\n    if real:\n        bl.node("lab_robot", "driver")\n    bl.node("lab_arm", "arm")\n'
)
ROS2 = {
    "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "launch/show.launch.py": "from launch import LaunchDescription\n",
}


@pytest.mark.parametrize(
    ("files", "started"),
    [
        ({"launch/map.launch.py": LAUNCHED}, "map.launch.py"),
        ({"launch/map.launch.xml": "<launch/>"}, "map.launch.xml"),
        ({"launch/map.launch": "<launch><node exec='a'/></launch>", "launch/map.launch.py": LAUNCHED}, "map.launch"),
        ({"launch/map.launch.xml": "<launch/>", "launch/map.launch.py": LAUNCHED}, "show.launch.py"),  # which of both?
        ({"launch/map.launch.py": ""}, "show.launch.py"),
        ({"launch/map.launch.txt": "<launch/>"}, "show.launch.py"),
    ],
)
def test_a_name_without_its_last_ending(tree: Tree, files: dict[str, str], started: str) -> None:
    page = "ROS Jazzy\n```\nros2 launch demo map.launch\nros2 launch demo show.launch.py\n```\n"
    assert tree({**ROS2, **files, "README.md": page}).command == ("ros2", "launch", "demo", started)


def test_what_a_launch_file_needs_that_describes_nothing(tree: Tree) -> None:
    page = "ROS Jazzy\n```\nros2 launch demo map.launch.py\n```\n"
    found = tree({**ROS2, "launch/map.launch.py": LAUNCHED, "README.md": page})
    told = [each.message for each in found.warnings if "default command needs the package" in each.message]
    assert ["lab_arm" in each for each in told] == [True]


@pytest.mark.parametrize(("blanks", "filled"), [(3, True), (4, False), (20, False)])
def test_a_name_of_many_blanks_is_left_as_it_is(blanks: int, *, filled: bool) -> None:
    said = ("roslaunch", "demo", f"{'aXX' * blanks}.launch")
    whole, other = f"{'a' * 60}.launch", f"{'a' * 120}-.launch"
    assert with_a_launch_file(said, {"demo": frozenset({whole, other})})[2] == (whole if filled else said[2])


@pytest.mark.parametrize(
    ("said", "given"),
    [
        ("address := <ip>", ()),
        ("address := 10.0.0.1", ("address:=10.0.0.1",)),
        ("address:= 10.0.0.1 rviz := false", ("address:=10.0.0.1", "rviz:=false")),
        ("address :=10.0.0.1 rviz:=false", ("address:=10.0.0.1", "rviz:=false")),
        ("address:= rviz:=false", ("rviz:=false",)),
    ],
)
def test_a_value_with_blanks_before_it_belongs_to_its_argument(tree: Tree, said: str, given: tuple[str, ...]) -> None:
    launch = '<launch><arg name="address" default="127.0.0.1"/><arg name="rviz" default="true"/></launch>\n'
    page = f"ROS Noetic\n```\nroslaunch demo show.launch {said}\n```\n"
    command = tree({**FILES, "launch/show.launch": launch, "README.md": page}).command
    assert command == ("roslaunch", "demo", "show.launch", *given)
