"""A launch file whose name its package has twice is started by its path."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "demo/package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "demo/CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "demo/launch/flat/plan.launch": "<launch/>\n",
    "demo/launch/flat/side.launch": "<launch/>\n",
}
TWICE = {**FILES, "demo/launch/deep/plan.launch": "<launch/>\n"}


@pytest.mark.parametrize(
    ("files", "lines", "command"),
    [
        (TWICE, "cd ./demo/launch/deep\nroslaunch plan.launch", ("roslaunch", "demo/launch/deep/plan.launch")),
        (TWICE, "roslaunch demo/launch/flat/plan.launch", ("roslaunch", "demo/launch/flat/plan.launch")),
        (TWICE, "roslaunch side.launch", ("roslaunch", "demo", "side.launch")),
        (FILES, "cd ./demo/launch/flat\nroslaunch plan.launch a:=1", ("roslaunch", "demo", "plan.launch", "a:=1")),
        (FILES, "roslaunch demo/launch/flat/plan.launch", ("roslaunch", "demo", "plan.launch")),
    ],
)
def test_the_path_tells_files_of_one_name_apart(
    tree: Tree, files: dict[str, str], lines: str, command: tuple[str, ...]
) -> None:
    assert tree({**files, "README.md": f"ROS Noetic\n```\n{lines}\n```\n"}).command == command


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        ('To run it, use "roslaunch paper/src/all.launch"', ("roslaunch", "src/all.launch")),
        (
            "```\nroslaunch ~/catkin_ws/src/paper/src/demo/all.launch a:=1\n```",
            ("roslaunch", "demo", "all.launch", "a:=1"),
        ),
        ("```\nroslaunch src/arm/all.launch\n```", ("roslaunch", "arm", "all.launch")),
        ("```\nroslaunch paper/src/hand/all.launch\n```", ("bash",)),
    ],
)
def test_a_path_may_begin_above_the_repository(tree: Tree, lines: str, command: tuple[str, ...]) -> None:
    files = {f"src/{path}": text for path, text in FILES.items()}
    files |= {path.replace("demo", "arm"): text.replace("demo", "arm") for path, text in files.items()}
    files |= dict.fromkeys(("src/all.launch", "src/demo/all.launch", "src/arm/all.launch"), "<launch/>\n")
    assert tree({**files, "README.md": f"ROS Noetic\n\n{lines}\n"}).command == command


def test_what_nobody_runs_is_called_so_too(tree: Tree) -> None:
    called = {candidate[1:] for candidate in tree(TWICE).command_candidates}
    assert called == {("demo", "side.launch"), ("demo/launch/deep/plan.launch",), ("demo/launch/flat/plan.launch",)}


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        ("roslaunch src/paper/launch/all.launch a:=1", ("roslaunch", "launch/all.launch", "a:=1")),
        ("roslaunch launch/all.launch", ("roslaunch", "launch/all.launch")),
        ("roslaunch src/paper/launch/none.launch", ("bash",)),
        ("roslaunch overall.launch", ("bash",)),
        (
            "cd <the clone>/tools/maze  # yours\nroslaunch launch/maze.launch",
            ("roslaunch", "tools/maze/launch/maze.launch"),
        ),
        ("roslaunch launch/twice.launch", ("bash",)),
        ("roslaunch maze.launch", ("bash",)),
        ("cd launch && roslaunch all.launch", ("roslaunch", "launch/all.launch")),
    ],
)
def test_a_launch_file_of_no_package_by_its_path_from_the_workspace(
    tree: Tree, lines: str, command: tuple[str, ...]
) -> None:
    others = {f"demo/launch/{name}.launch": "<launch/>\n" for name in ("a", "b")}
    apart = ("maze/launch/maze", "maze/launch/twice", "hall/launch/twice")
    others |= {f"tools/{path}.launch": "<launch/>\n" for path in apart}
    files = {**FILES, **others, "launch/all.launch": "<launch/>\n"}
    assert tree({**files, "README.md": f"ROS Noetic\n```\n{lines}\n```\n"}).command == command


@pytest.mark.parametrize(
    ("page", "said", "command"),
    [
        ("maze/README.md", "going into launch and running `ros2 launch maze_launch.py`", "maze/launch/maze_launch.py"),
        ("maze/README", "Launch it with `ros2 launch launch/launch.py`", "maze/launch/launch.py"),
        ("maze/README.md", "Launch it with `ros2 launch hall_launch.py`", ""),
        ("README.md", "Launch it with `ros2 launch maze_launch.py`", ""),
        ("README.md", "Launch it with `ros2 launch top_launch.py`", "launch/top_launch.py"),
    ],
)
def test_the_page_of_a_folder_names_its_launch_files_from_there(tree: Tree, page: str, said: str, command: str) -> None:
    """They belong to no package, which lies deeper, and one may be called ``launch.py`` alone."""
    node = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='demo', executable='drive')])\n"
    )
    manifest = (
        "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend></package>"
    )
    cmake = (
        "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_executable(drive a.cpp)\nadd_executable(watch a.cpp)\n"
    )
    files = {
        "maze/src/demo/package.xml": manifest,
        "maze/src/demo/CMakeLists.txt": cmake,
        page: f"# ROS 2 Humble\n\n{said}\n",
    }
    apart = (
        "maze/launch/maze_launch.py",
        "maze/launch/launch.py",
        "hall/launch/hall_launch.py",
        "launch/top_launch.py",
    )
    files |= dict.fromkeys((*apart, "hall/launch/launch.py"), node)
    assert tree(files).command == (("ros2", "launch", command) if command else ("bash",))


NODES = {
    "robot/package.xml": "<package><name>robot</name><buildtool_depend>catkin</buildtool_depend></package>",
    "robot/CMakeLists.txt": "project(robot)\nfind_package(catkin REQUIRED)\nadd_executable(drive a.cpp)\n",
    "extra/package.xml": "<package><name>extra</name><buildtool_depend>catkin</buildtool_depend></package>",
    "extra/CMakeLists.txt": "project(extra)\nfind_package(catkin REQUIRED)\nadd_executable(watch a.cpp)\n",
}


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        ("rosrun extra watch 1", "rosrun extra watch 1"),
        ("rosrun robot watch 1", "rosrun extra watch 1"),
        ("rosrun extra watch.cpp 1", "rosrun extra watch 1"),
        ("rosrun robot watch.cpp 1", "rosrun extra watch 1"),
        ("rosrun extra other.cpp 1", "rosrun extra other.cpp 1"),
        ("rosrun acme_nowhere drive\nrosrun robot drive", "rosrun robot drive"),
        ("roslaunch acme_nowhere a.launch\nrosrun robot drive", "rosrun robot drive"),
        ("rosrun xacro xacro robot.xacro\nrosrun robot drive", "rosrun robot drive"),
        ("rosrun collada_urdf urdf_to_collada a.urdf a.dae\nrosrun robot drive", "rosrun robot drive"),
    ],
)
def test_a_package_that_nothing_has_starts_nothing(tree: Tree, lines: str, command: str) -> None:
    """A page may also name the wrong one of the tree's packages, or the source of a program."""
    found = tree({**NODES, "README.md": f"ROS Noetic\n```\n{lines}\n```\n"}).command
    assert " ".join(found) == command


@pytest.mark.parametrize(
    ("line", "command"),
    [
        ("roslaunch --screen demo side.launch a:=1", ("roslaunch", "demo", "side.launch", "a:=1", "--screen")),
        ("roslaunch --wait -v demo/launch/flat/side.launch", ("roslaunch", "demo", "side.launch", "--wait", "-v")),
        ("roslaunch --screen", ("bash",)),
    ],
)
def test_options_may_stand_before_the_package(tree: Tree, line: str, command: tuple[str, ...]) -> None:
    assert tree({**FILES, "README.md": f"ROS Noetic\n\n```\n{line}\n```\n"}).command == command


@pytest.mark.parametrize(
    ("demanded", "first", "given", "command"),
    [
        (
            "host_name",
            "demo plan.launch",
            "demo plan.launch host_name:=10.1.2.3",
            "demo plan.launch host_name:=10.1.2.3",
        ),
        (
            "host_name",
            "--screen demo/launch/flat/plan.launch",
            "demo plan.launch host_name:=a",
            "demo plan.launch host_name:=a",
        ),
        ("host_name", "demo plan.launch", "demo plan.launch other:=1", "demo side.launch"),
    ],
)
def test_what_the_readme_starts_takes_the_arguments_of_another_page(
    tree: Tree, demanded: str, first: str, given: str, command: str
) -> None:
    files = {**FILES, "demo/launch/flat/plan.launch": f'<launch><arg name="{demanded}"/></launch>\n'}
    pages = {
        "README.md": f"ROS Noetic\n\n## Installation\n```\nroslaunch {first}\n```\n",
        "demo/README.md": f"## System setup\n```\nroslaunch {given}\n```\n",
        "demo/launch/README.md": "## Usage\n```\nroslaunch demo side.launch\n```\n",
    }
    assert tree({**files, **pages}).command == ("roslaunch", *command.split())
