"""The default command where the README runs a package that only a clone beside the repository brings."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LIST = "- git: {local-name: walker-examples, uri: 'https://github.com/acme/walker-examples.git'}\n"
PACKAGE = "<package><name>walker_core</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "project(walker_core)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
LINK = "The [examples](https://github.com/acme/walker-examples) show it.\n\n"


def _files(run: str, before: str = "", **more: str) -> dict[str, str]:
    page = f"# Walker\n\nFor ROS noetic.\n\n## Quick start\n\n{before}```\n{run}\n```\n"
    launch = {f"walker_core/launch/{name}.launch": "<launch/>\n" for name in ("arm", "leg", "eye")}
    tree = {"README.md": page, "deps.rosinstall": LIST, "walker_core/package.xml": PACKAGE, **launch}
    return {**tree, "walker_core/CMakeLists.txt": CMAKE, **{k.replace("__", "/"): v for k, v in more.items()}}


@pytest.mark.parametrize(
    ("run", "before", "command"),
    [
        ("roslaunch walker_examples sim.launch", "", ("roslaunch", "walker_examples", "sim.launch")),
        ("roslaunch walker_examples_arm sim.launch", "", ("roslaunch", "walker_examples_arm", "sim.launch")),
        ("roslaunch simple_demo sim.launch", LINK, ("roslaunch", "simple_demo", "sim.launch")),
        ("rosrun simple_demo sim_node", LINK, ("rosrun", "simple_demo", "sim_node")),
        # nothing tells that the clone has it
        ("roslaunch simple_demo sim.launch", "", ("bash",)),
        ("roslaunch simple_demo sim.launch", LINK + "\n" * 40, ("bash",)),
        # the distribution has it, a blank, and a slip for the tree's own package
        ("roslaunch turtlebot3_gazebo world.launch", LINK, ("bash",)),
        ("roslaunch your_package sim.launch", LINK, ("bash",)),
        # another distribution has it
        ("roslaunch carl_bringup a.launch", LINK, ("roslaunch", "carl_bringup", "a.launch")),
        # a page runs the tree's own
        (
            "roslaunch simple_demo sim.launch\nroslaunch walker_core arm.launch",
            LINK,
            ("roslaunch", "walker_core", "arm.launch"),
        ),
    ],
)
def test_a_package_of_a_listed_clone(tree: Tree, run: str, before: str, command: tuple[str, ...]) -> None:
    found = tree(_files(run, before))
    assert found.command == command
    assert ("simple_demo" in found.must_build) == ("simple_demo" in command)


def test_no_list_brings_it(tree: Tree) -> None:
    files = _files("roslaunch walker_examples sim.launch", LINK)
    del files["deps.rosinstall"]
    assert tree(files).command == ("bash",)


def test_the_reason_says_where_it_is_from(tree: Tree) -> None:
    found = tree(_files("roslaunch walker_examples sim.launch"))
    why = [each.reason for each in found.reasons if each.question == "command" and each.decisive]
    assert why == ["the README runs it, of a repository that is cloned beside this one"]
