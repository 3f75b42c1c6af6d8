"""A page that clones the repository itself is understood, though a fork, a mirror or a tarball has another name."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TREE = {
    "robot_helper/package.xml": (
        "<package><name>robot_helper</name><buildtool_depend>catkin</buildtool_depend>"
        "<depend>roscpp</depend><depend>arm_msgs</depend></package>"
    ),
    "robot_helper/CMakeLists.txt": "project(robot_helper)\nfind_package(catkin REQUIRED COMPONENTS arm_msgs)\n",
    "other/package.xml": "<package><name>other</name><buildtool_depend>catkin</buildtool_depend></package>",
    "other/CMakeLists.txt": "project(other)\nfind_package(catkin REQUIRED)\n",
}
BLOCK = "```\ncd ws/src\ngit clone https://github.com/me/{name}.git\ngit clone https://github.com/me/arms.git\n```\n"


def names(decision: Decision) -> set[str]:
    return {source.name for source in decision.source if not source.holding}


@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("ROS Noetic\n\n4. Clone this repo and what it needs: (with `YOU`)\n", "course-2022"),
        ("ROS Noetic\n\nPlease clone our package into the workspace.\n\n", "course-2022"),
        ("# Course 2022\nROS Noetic\n# Install\n", "course-2022"),
        ("ROS Noetic\n", "robot_helper"),  # one of its own packages
        ("ROS Noetic\n", "demo"),
    ],
)
def test_it_is_not_cloned_beside_itself(tree: Tree, page: str, name: str) -> None:
    decision = tree({**TREE, "README.md": f"{page}{BLOCK.format(name=name)}"})
    assert names(decision) == {"arms"}
    assert not any(name in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    "page",
    [
        "ROS Noetic\n\nClone the drivers:\n",
        "# Demo\nROS Noetic\n\nClone this repo first.\n\nThen clone the drivers.\n",
    ],
)
def test_another_repository_is(tree: Tree, page: str) -> None:
    assert names(tree({**TREE, "README.md": f"{page}{BLOCK.format(name='course-2022')}"})) == {"arms", "course-2022"}


def test_what_a_manifest_asks_for_is_not_the_repository(tree: Tree) -> None:
    page = f"ROS Noetic\n\nClone this repo and what it needs:\n{BLOCK.format(name='arm_msgs')}"
    assert "arm_msgs" in names(tree({**TREE, "README.md": page}))


@pytest.mark.parametrize(
    ("title", "cloned"),
    [("Install required simulation packages", {"arms"}), ("Simulation packages (not required)", set())],
)
def test_a_title_that_says_what_is_required(tree: Tree, title: str, cloned: set[str]) -> None:
    released = {path: text.replace("<depend>arm_msgs</depend>", "") for path, text in TREE.items()}
    released["robot_helper/CMakeLists.txt"] = "project(robot_helper)\nfind_package(catkin REQUIRED)\n"
    page = f"# Demo\nROS Noetic\n## {title}\n{BLOCK.format(name='demo')}"
    assert names(tree({**released, "README.md": page})) == cloned
