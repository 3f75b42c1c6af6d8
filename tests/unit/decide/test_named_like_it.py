"""Which node is the default: not a helper, not one that wants arguments, and what a function of the shell starts."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>"
CMAKE = "project({})\nfind_package(ament_cmake REQUIRED)\n{}"


def _package(name: str, *programs: str) -> dict[str, str]:
    made = "".join(f"add_executable({each} a.cpp)\n" for each in programs)
    return {f"{name}/package.xml": PACKAGE.format(name), f"{name}/CMakeLists.txt": CMAKE.format(name, made)}


def _command(tree: Tree, files: dict[str, str], page: str, title: str = "Demo") -> str:
    decision = tree(files | {"README.md": f"# {title}\n\n## Usage\n\n```bash\n{page}\n```\n"})
    return " ".join(decision.command)


@pytest.mark.parametrize(
    ("title", "helper", "command"),
    [
        ("Wheel Odometry", "state_publisher", "ros2 run wheel_odometry wheel_node"),
        ("Wheel Odometry", "camera", "ros2 run camera camera"),
        ("State Publisher", "state_publisher", "ros2 run state_publisher state_publisher"),
        ("Something else", "state_publisher", "ros2 run state_publisher state_publisher"),
    ],
)
def test_what_the_repository_is_called_after_comes_before_helpers(
    tree: Tree, title: str, helper: str, command: str
) -> None:
    files = _package(helper, helper) | _package("wheel_odometry", "wheel_node") | _package("other", "other")
    page = f"ros2 run {helper} {helper}\nros2 run other other\nros2 run wheel_odometry wheel_node"
    assert _command(tree, files, page, title) == command


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("ros2 run bag_recorder record_headless", "ros2 run bag_recorder record_headless"),
        ("ros2 run bag_recorder record_headless --config /path/to/a.yaml", "ros2 run bag_recorder record_headless"),
        ("ros2 run bag_recorder record <args>", "bash"),
        ("ros2 run bag_recorder record <args>\nros2 run bag_recorder record -a", "ros2 run bag_recorder record -a"),
        (
            "ros2 run bag_recorder record <args>\nros2 run bag_recorder record_headless",
            "ros2 run bag_recorder record_headless",
        ),
    ],
)
def test_a_node_that_a_page_gives_arguments_is_no_default_without(tree: Tree, page: str, command: str) -> None:
    files = _package("bag_recorder", "record") | {"bag_recorder/a.md": ""}
    if "headless" in page:
        files = _package("bag_recorder", "record", "record_headless")
    assert _command(tree, files, page) == command


@pytest.mark.parametrize(
    ("script", "command"),
    [
        ('watch_all() {\n  ros2 run watcher look "$@"\n}\n', "ros2 run watcher look --all"),
        ('function watch_all() { ros2 run watcher look "$@"; }\n', "ros2 run watcher look --all"),
        ("alias watch_all='ros2 run watcher look'\n", "ros2 run watcher look --all"),
        ("watch_all() {\n  ros2 run watcher look\n}\n", "bash"),
        ('watch_all() {\n  cd /tmp\n  ros2 run watcher look "$@"\n}\n', "bash"),
        ('watch_all() { ros2 run watcher look "$NAME" "$@"; }\n', "bash"),
    ],
)
def test_a_page_calls_a_function_of_the_repositorys_script(tree: Tree, script: str, command: str) -> None:
    files = _package("watcher", "look", "think") | {"watcher/scripts/functions.bash": script}
    assert _command(tree, files, "watch_all --all") == command
