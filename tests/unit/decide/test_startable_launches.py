"""A launch file that cannot start, or that starts nothing of the repository, is not guessed to be the program."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": (
        "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend>"
        "<run_depend>lab_driver</run_depend></package>"
    ),
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(demo_node a.cpp)\n",
    "a.cpp": "int main() {}\n",
}
NODE = ("rosrun", "demo", "demo_node")
LAUNCH = ("roslaunch", "demo", "dataset.launch")
OWN = '<node pkg="demo" type="demo_node" name="a"/>'


def command(tree: Tree, launch: str, more: dict[str, str] | None = None) -> tuple[str, ...] | str:
    return tree({**PACKAGE, "launch/dataset.launch": f"<launch>{launch}</launch>", **(more or {})}).command


@pytest.mark.parametrize(
    "launch",
    [
        f'{OWN}<node pkg="nobodys_filter" type="x" name="b"/>',
        f'{OWN}<arg name="a" default="1"/><node if="$(arg a)" pkg="nobodys_filter" type="x" name="b"/>',
        f'{OWN}<rosparam file="$(find nobodys_filter)/a.yaml"/>',
        '<node pkg="rviz" type="rviz" name="b"/>',
    ],
)
def test_the_one_compiled_program_comes_before_it(tree: Tree, launch: str) -> None:
    assert command(tree, launch) == NODE


def test_else_it_is_a_shell(tree: Tree) -> None:
    more = {"CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"}
    assert command(tree, '<node pkg="nobodys_filter" type="x" name="b"/>', more) == ("bash",)


@pytest.mark.parametrize(
    ("launch", "more"),
    [
        (OWN, {}),
        (f'{OWN}<node pkg="lab_driver" type="x" name="b"/>', {}),  # a package.xml asks for it
        (f'{OWN}<node pkg="topic_tools" type="drop" name="b"/>', {}),
        (f'{OWN}<arg name="a" default="0"/><node if="$(arg a)" pkg="nobodys_filter" type="x" name="b"/>', {}),
        (
            f'{OWN}<node pkg="nobodys_filter" type="x" name="b"/>',  # a clone may hold it
            {"README.md": "```\ncd ws/src\ngit clone https://github.com/lab/filters.git\n```\n"},
        ),
        (f'{OWN}<node pkg="nobodys_filter" type="x" name="b"/>', {"README.md": "`roslaunch demo dataset.launch`\n"}),
        (
            '<node pkg="rviz" type="rviz" name="b"/>',  # launch files are all that it has
            {"CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"},
        ),
        (
            '<node pkg="rviz" type="rviz" name="b"/><include file="$(dirname)/other.launch.xml"/>',
            {"launch/other.launch.xml": f"<launch>{OWN}</launch>"},
        ),
    ],
)
def test_what_may_start_is_guessed_as_ever(tree: Tree, launch: str, more: dict[str, str]) -> None:
    assert command(tree, launch, more) == LAUNCH


@pytest.mark.parametrize(("distro", "told"), [("kinetic", False), ("noetic", True)])
def test_a_package_that_the_table_has_for_other_distributions_is_told(tree: Tree, distro: str, told: bool) -> None:
    files = {
        **PACKAGE,
        "launch/dataset.launch": f'<launch>{OWN}<node pkg="baxter_gazebo" type="x" name="b"/></launch>',
        "README.md": f"For ROS {distro}.\n```\nroslaunch demo dataset.launch\n```\n",
    }
    warned = [warning.message for warning in tree(files).warnings if "baxter_gazebo" in warning.message]
    assert bool(warned) is told


SETS = '<param name="a" value="1"/><rosparam file="$(find demo)/a.yaml"/><!-- <node pkg="demo"/> -->'


def test_what_sets_parameters_alone_starts_nothing(tree: Tree) -> None:
    assert command(tree, SETS) == NODE
    assert command(tree, SETS, {"CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"}) == ("bash",)


@pytest.mark.parametrize(
    "beside",
    [OWN, '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>', '<gz_server world_sdf_file="empty.sdf"/>'],
)
def test_what_starts_a_node_or_another_launch_file_beside_them_does(tree: Tree, beside: str) -> None:
    assert command(tree, f"{SETS}{beside}") == LAUNCH


def test_a_page_that_runs_such_a_launch_file_first_means_what_it_runs_then(tree: Tree) -> None:
    page = "# Run\n```\nroslaunch demo dataset.launch\nroslaunch demo start.launch\n```\n"
    more = {"README.md": page, "launch/start.launch": f"<launch>{OWN}</launch>"}
    assert command(tree, SETS, more) == ("roslaunch", "demo", "start.launch")


def test_a_page_that_names_one_alone_means_the_program(tree: Tree) -> None:
    assert command(tree, SETS, {"README.md": "# Run\nAll is set in launch/dataset.launch.\n"}) == NODE


def test_a_launch_file_without_parameters_is_not_told_by_them(tree: Tree) -> None:
    assert command(tree, '<arg name="a" default="1"/>') == LAUNCH


@pytest.mark.parametrize(
    ("folder", "command"),
    [
        ("old-launch", LAUNCH),
        ("deprecated", LAUNCH),
        ("launch_old", LAUNCH),
        ("older_adults", ("bash",)),
        ("gold", ("bash",)),
    ],
)
def test_a_launch_file_of_a_folder_of_old_ones_competes_with_none(
    tree: Tree, folder: str, command: tuple[str, ...]
) -> None:
    node = f"<launch>{OWN}</launch>"
    files = {"launch/dataset.launch": node, f"launch/{folder}/other.launch": node}
    assert tree(PACKAGE | files).command == command


def test_where_all_are_old_one_of_them_is_meant(tree: Tree) -> None:
    assert tree(PACKAGE | {"launch/old-launch/dataset.launch": f"<launch>{OWN}</launch>"}).command == LAUNCH
