"""What a page, or a script that it runs, clones beside the repository into the workspace."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
MADE = "project(demo)\nfind_package(catkin REQUIRED)\n"
LAUNCH = "<launch><node pkg='acme_control' type='control' name='c'/></launch>"
SHOWN = {"package.xml": PACKAGE, "CMakeLists.txt": MADE, "launch/demo.launch": LAUNCH}
PAGE = """\
ROS Noetic
## Installation
```
cd ~/catkin_ws/src
git clone https://github.com/me/demo.git
git clone https://github.com/lab/vehicles.git
cd ..
git clone https://github.com/lab/firmware.git
catkin_make
```
"""
SCRIPT = """\
SRC=${HOME}/catkin_ws/src
if [ ! -d "$SRC/vehicles" ]; then
    cd $SRC
    git clone https://github.com/lab/vehicles.git
else
    cd $SRC/vehicles
    git pull
fi
cd $SRC/vehicles
git checkout for_noetic
cd $HOME
git clone https://github.com/lab/firmware.git
catkin build
"""


def cloned(decision: Decision) -> list[tuple[str, str | None]]:
    return [(source.name, source.ref) for source in decision.source]


def test_a_page_clones_beside_it(tree: Tree) -> None:
    assert cloned(tree(SHOWN | {"README.md": PAGE})) == [("vehicles", None)]
    older = PAGE.replace("me/demo.git", "me/de-mo.git")
    assert cloned(tree(SHOWN | {"README.md": older})) == [("vehicles", None)]


@pytest.mark.parametrize(
    ("folder", "there"),
    [
        ("~/ros/noetic/src", [("vehicles", None)]),
        ("~/Noetic/src", [("vehicles", None)]),
        ("~/programs/src", []),
        ("~/noetic/demo", []),
    ],
)
def test_a_workspace_is_called_like_a_distribution(
    tree: Tree, folder: str, there: list[tuple[str, str | None]]
) -> None:
    known = SHOWN | {"launch/demo.launch": LAUNCH.replace("acme_control", "map_server")}
    assert cloned(tree(known | {"README.md": PAGE.replace("~/catkin_ws/src", folder)})) == there


def test_nothing_unknown_is_needed(tree: Tree) -> None:
    known = SHOWN | {"launch/demo.launch": LAUNCH.replace("acme_control", "map_server")}
    alone = PAGE.replace("git clone https://github.com/me/demo.git\n", "")
    assert not cloned(tree(known | {"README.md": alone}))
    for module, there in (("numpy", []), ("torch", []), ("acme_control", [("vehicles", None)])):
        code = {"scripts/a.py": f"#!/usr/bin/env python3\nimport {module}\n"}
        assert cloned(tree(known | {"README.md": alone} | code)) == there
    assert cloned(tree(SHOWN | {"README.md": alone})) == [("vehicles", None)]


OWN = "git clone https://github.com/me/demo.git\n"
FORK = "git clone https://github.com/me/navigation.git\n"
BRANCH = "git clone -b for_demo https://github.com/lab/navigation.git\n"
RELEASED = "git clone https://github.com/ros-planning/navigation.git\n"


@pytest.mark.parametrize(
    ("lines", "names"),
    [
        (OWN + FORK, ["navigation"]),
        (OWN + BRANCH, ["navigation"]),
        (OWN + RELEASED, []),
        (OWN + "# Optional, a model to look at\ngit clone https://github.com/lab/things.git\n", []),
        (OWN + "```\nIf you want to see more:\n```\ngit clone https://github.com/lab/things.git\n", []),
        (OWN + "```\n## Simulation\n```\ngit clone https://github.com/lab/things.git\n", []),
        (OWN + "git clone https://github.com/lab/things.git\n", ["things"]),
    ],
)
def test_what_everybody_clones_where_the_repository_itself_is_cloned(tree: Tree, lines: str, names: list[str]) -> None:
    """The title of the page is no section: it tells what the code is for."""
    files = {"package.xml": PACKAGE, "CMakeLists.txt": MADE}
    page = f"# Simulation of a demo\nROS Noetic\n```\ncd ~/catkin_ws/src\n{lines}```\n"
    assert [name for name, _ in cloned(tree(files | {"README.md": page}))] == names


@pytest.mark.parametrize("title", ["## Optional", "### Simulation", "## With Docker"])
def test_a_section_that_not_everybody_follows(tree: Tree, title: str) -> None:
    assert not cloned(tree(SHOWN | {"README.md": PAGE.replace("## Installation", title)}))


def test_a_script_that_the_page_runs(tree: Tree) -> None:
    run = {"README.md": "ROS Noetic\n```\ncd install\n./setup.sh\n```\n", "install/setup.sh": SCRIPT}
    decision = tree(SHOWN | run)
    assert cloned(decision) == [("vehicles", "for_noetic")]
    assert decision.build_tool == "catkin_tools"


SISTERS = """\
cd ..
git clone https://github.com/lab/firmware.git
cd firmware
git checkout for_noetic
cd ..
git clone https://github.com/lab/vehicles.git
"""


@pytest.mark.parametrize(
    ("file", "text", "names"),
    [
        ("install.sh", SISTERS, ["firmware", "vehicles"]),
        ("install.sh", SISTERS.replace("..", "lib", 1), []),
        ("install.sh", SISTERS.replace("..", "../..", 1), []),
        ("install/install.sh", SISTERS, []),
        ("install.sh", SISTERS.replace("..", "~/catkin_ws/src", 1), ["firmware", "vehicles"]),
        ("install.sh", SISTERS.replace("..", "~/catkin_ws/src", 1).replace("..", "../.."), ["firmware"]),
    ],
)
def test_where_a_script_goes_back_to(tree: Tree, file: str, text: str, names: list[str]) -> None:
    """A script of the root that leaves the repository is among the packages of the workspace, if it is in one."""
    decision = tree(SHOWN | {"README.md": f"ROS Noetic\n```\n./{file}\n```\n", file: text})
    assert [name for name, _ in cloned(decision)] == names


def test_a_script_that_no_page_runs(tree: Tree) -> None:
    assert not cloned(tree(SHOWN | {"README.md": "ROS Noetic\n", "install/setup.sh": SCRIPT}))


def test_a_clone_for_another_distribution(tree: Tree) -> None:
    page = PAGE.replace("git clone https://github.com/lab/v", "git clone -b melodic-devel https://github.com/lab/v")
    assert not cloned(tree(SHOWN | {"README.md": page}))
    both = page.replace("cd ..", "git clone -b noetic-devel https://github.com/lab/vehicles.git\ncd ..")
    assert cloned(tree(SHOWN | {"README.md": both})) == [("vehicles", "noetic-devel")]


CI = """\
on: push
jobs:
  industrial_ci:
    strategy:
      matrix:
        env:
          - {ROS_DISTRO: noetic, UPSTREAM_WORKSPACE: 'github:lab/vehicles#devel -vehicles/simulated'}
    runs-on: ubuntu-latest
    steps: [{uses: ros-industrial/industrial_ci@master}]
"""


@pytest.mark.parametrize(
    ("file", "text"),
    [
        (".github/workflows/ci.yml", CI),
        (
            ".github/workflows/ci.yml",
            CI.replace("github:lab/vehicles", "sisters.repos git+https://github.com/lab/vehicles.git"),
        ),
        (".travis.yml", "env:\n  matrix:\n    - ROS_DISTRO=noetic UPSTREAM_WORKSPACE='github:lab/vehicles#devel'\n"),
        (".gitlab-ci.yml", "build:\n  variables:\n    UPSTREAM_WORKSPACE: >\n      github:lab/vehicles#devel\n"),
    ],
)
def test_what_industrial_ci_builds_first(tree: Tree, file: str, text: str) -> None:
    decision = tree(SHOWN | {file: text, "README.md": "ROS Noetic\n"})
    assert cloned(decision) == [("vehicles", "devel")]
    known = SHOWN | {"launch/demo.launch": LAUNCH.replace("acme_control", "map_server")}
    assert not cloned(tree(known | {file: text, "README.md": "ROS Noetic\n"}))


def test_what_industrial_ci_builds_for_another_distribution(tree: Tree) -> None:
    assert not cloned(tree(SHOWN | {".github/workflows/ci.yml": CI.replace("#devel", "#melodic-devel")}))
