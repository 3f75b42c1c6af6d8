"""What files of tmuxinator and scripts called after starting run is the command, where no page runs anything."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SESSION = (
    "name: simulation\nroot: ./\nwindows:\n  - core:\n      layout: tiled\n      panes:\n        - roscore\n"
    "  - sim:\n      layout: tiled\n      panes:\n"
    "        - waitForRos; roslaunch demo a.launch config:=./config/a.yaml\n"
)
TMUXP = (
    "session_name: x\nwindows:\n  - window_name: one\n    panes:\n      - shell_command:\n"
    "          - roslaunch demo a.launch\n"
)
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(node a.cpp)\n",
    "launch/a.launch": '<launch><arg name="config" default=""/></launch>',
    "launch/b.launch": "<launch/>",
    "tmux/one/config/a.yaml": "a: 1\n",
    "README.md": "# Demo\nA simulator for ROS Noetic.\n",
}
A = ("roslaunch", "demo", "a.launch")
B = ("roslaunch", "demo", "b.launch")
CONFIGURED = (*A, "config:=tmux/one/config/a.yaml")


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({"tmux/one/session.yml": SESSION}, CONFIGURED),
        ({"tmux/one/session.yml": TMUXP}, A),
        ({"start.sh": "#!/bin/bash\nsource devel/setup.bash\nroslaunch demo a.launch\n"}, A),
        ({"tmux/one/session.yml": SESSION, "tmux/two/session.yml": SESSION.replace("a.launch", "b.launch")}, ("bash",)),
        ({"tmux/one/session.yml": SESSION.replace("panes", "lines").replace("layout", "form")}, ("bash",)),
        ({"tmux/one/session.yml": SESSION, "tmux/two/session.yml": TMUXP + SESSION[SESSION.index("  - sim") :]},
         CONFIGURED),
        ({"tmux/one/session.yml": SESSION.replace("demo a.launch", "other a.launch")}, ("bash",)),
        ({"scripts/start_it.sh": 'roslaunch demo "$1"\n'}, ("bash",)),
        ({"restart.sh": "roslaunch demo a.launch\n"}, ("bash",)),
    ],
)  # fmt: skip
def test_what_all_sessions_start_first(tree: Tree, files: dict[str, str], command: tuple[str, ...]) -> None:
    assert tree(FILES | files).command == command


def test_what_a_page_runs_comes_first(tree: Tree) -> None:
    page = "# Demo\n## Run\n```\nroslaunch demo b.launch\n```\n"
    decision = tree(FILES | {"tmux/one/session.yml": SESSION, "README.md": page})
    assert decision.command == ("roslaunch", "demo", "b.launch")
    assert CONFIGURED not in decision.command_candidates


def test_a_session_counts_more_than_the_name_of_a_launch_file(tree: Tree) -> None:
    files = FILES | {"launch/demo.launch": "<launch/>"}
    assert tree(files).command == ("roslaunch", "demo", "demo.launch")
    decision = tree(files | {"tmux/one/session.yml": SESSION})
    assert decision.command == CONFIGURED
    assert any(r.reason == "tmux/one/session.yml starts it" and r.line == 11 for r in decision.reasons)


def test_a_session_that_holds_itself_ends(tree: Tree) -> None:
    held = "windows:\n  - &b {layout: x, panes: [*b, 'roslaunch demo a.launch']}\n"
    assert tree(FILES | {"tmux/one/session.yml": held}).kind == "ros1"


LOADS = "# Demo\n## Run\n```\ncd tmux/one\n{}\n```\nThen run `roslaunch demo b.launch`.\n"


@pytest.mark.parametrize(
    ("loads", "more", "command"),
    [
        ("tmuxp load session.yml", {}, A),
        ("tmuxp load -d ./session.yml", {}, A),
        ("tmuxinator start -p session.yml", {}, A),
        ("tmuxinator start --project-config=session.yml", {}, A),
        ("tmuxp load demo", {}, B),
        ("tmuxp load other.yml", {}, B),
        ("tmuxp freeze session.yml", {}, B),
        ("tmuxp load session.yml", {"tmux/two/session.yml": TMUXP}, B),
        ("tmuxp load tmux/one/session.yml", {"tmux/two/session.yml": TMUXP}, A),
        ("roslaunch demo b.launch; tmuxp load session.yml", {}, B),
    ],
)
def test_what_a_page_loads_it_runs(tree: Tree, loads: str, more: dict[str, str], command: tuple[str, ...]) -> None:
    decision = tree(FILES | {"tmux/one/session.yml": TMUXP, "README.md": LOADS.format(loads), **more})
    assert decision.command == command
