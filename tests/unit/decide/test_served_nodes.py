"""A page of a package of ROS may run only what draws the results of its node: the node is the default."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>mapper</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\nproject(mapper)\nfind_package(catkin REQUIRED)\n"
    "add_executable(localization src/a.cpp)\n",
    "src/a.cpp": "int main() {}\n",
    **dict.fromkeys((f"scripts/{name}.py" for name in ("graph_viewer", "plot_map", "mapping")), "print(1)\n"),
}
NODE = ("rosrun", "mapper", "localization")


@pytest.mark.parametrize(
    ("run", "more", "command"),
    [
        ("./scripts/graph_viewer.py", {}, NODE),
        ("python scripts/plot_map.py", {}, NODE),
        ("./scripts/mapping.py", {}, ("python3", "scripts/mapping.py")),
        ("./scripts/graph_viewer.py\nrosrun mapper localization", {}, NODE),
        ("./scripts/graph_viewer.py", {"launch/map.launch": ""}, ("roslaunch", "mapper", "map.launch")),
        (
            "./scripts/graph_viewer.py",
            {"launch/map.launch": "", "launch/other.launch": ""},
            ("python3", "scripts/graph_viewer.py"),
        ),
    ],
)
def test_the_only_node_is_taken(tree: Tree, run: str, more: dict[str, str], command: tuple[str, ...]) -> None:
    node = '<launch><node pkg="mapper" type="localization" name="a"/></launch>\n'
    page = {"README.md": f"# Mapper\n\nFor ROS Noetic.\n\n## Post processing\n\n```bash\n{run}\n```\n"}
    assert tree(FILES | page | dict.fromkeys(more, node)).command == command


def test_the_reason_says_what_the_page_runs(tree: Tree) -> None:
    page = {"README.md": "ROS Noetic\n```\npython scripts/plot_map.py\n```\n"}
    said = next(each.reason for each in tree(FILES | page).reasons if each.question == "command")
    assert "a program that its package compiles, and the README runs only what serves it" in said


@pytest.mark.parametrize(
    "launch",
    [
        '<launch><rosparam file="/path/to/a.yaml" command="load"/><node pkg="amcl" type="amcl" name="a"/></launch>\n',
        '<launch><include file="$(find mapper)/launch/gone.launch"/></launch>\n',
        '<launch><arg name="map"/><node pkg="amcl" type="amcl" name="a" args="$(arg map)"/></launch>\n',
    ],
)
def test_a_launch_file_that_stops_is_not_taken(tree: Tree, launch: str) -> None:
    page = "# Mapper\n\nFor ROS Noetic.\n\n## Post processing\n\n```bash\npython3 scripts/plot_map.py\n```\n"
    cmake = "project(mapper)\nfind_package(catkin REQUIRED)\n"
    files = {**FILES, "README.md": page, "CMakeLists.txt": cmake, "launch/map.launch": launch}
    assert tree(files).command == ("python3", "scripts/plot_map.py")
