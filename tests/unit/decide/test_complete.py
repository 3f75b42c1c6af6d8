"""Of distributions that are named alike, the one that has every declared package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BOTH = "# demo\n\nIt was tested on ROS 2 Humble and ROS 2 Jazzy.\n"


def _decided(tree: Tree, page: str, depends: str, **more: str) -> Decision:
    files = {
        "package.xml": '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
        f"<depend>rclcpp</depend>{depends}<export><build_type>ament_cmake</build_type></export></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "README.md": page,
        **more,
    }
    return tree(files)


@pytest.mark.parametrize(
    ("page", "depends", "chosen"),
    [
        (BOTH, "<depend>franka_description</depend>", "humble"),  # of which humble has a release, and jazzy none
        (BOTH, "<depend>nav2_msgs</depend>", "jazzy"),
        (BOTH, "<depend>our_own_msgs</depend>", "jazzy"),
        (BOTH, "<test_depend>franka_description</test_depend>", "jazzy"),
        (BOTH, "<depend>franka_description</depend><depend>moveit_py</depend>", "jazzy"),  # humble lacks one too
        ("For ROS 2 Jazzy.\n", "<depend>franka_description</depend>", "jazzy"),
        (BOTH.replace("Jazzy", "Rolling"), "<depend>franka_description</depend>", "humble"),
    ],
)
def test_the_one_that_has_all(tree: Tree, page: str, depends: str, chosen: str) -> None:
    assert _decided(tree, page, depends).ros_distro == chosen


RECOMMENDED = "# demo\n\nWe recommend ROS 2 Jazzy.\n\nTested on ROS 2 Humble.\n"
ONLY_RUN = "<exec_depend>franka_description</exec_depend>"


@pytest.mark.parametrize(
    ("page", "depends", "chosen"),
    [
        (RECOMMENDED, "<depend>franka_description</depend>", "humble"),
        (RECOMMENDED, "<depend>nav2_msgs</depend>", "jazzy"),
        (RECOMMENDED, ONLY_RUN, "jazzy"),  # it is compiled without
        (RECOMMENDED.replace("Tested on", "It does not work on"), "<depend>franka_description</depend>", "jazzy"),
        (
            RECOMMENDED.replace("Tested on", "Humble is gone, no longer tested on"),
            "<depend>franka_description</depend>",
            "jazzy",
        ),
    ],
)
def test_one_that_is_named_with_less_weight_and_has_what_compiling_needs(
    tree: Tree, page: str, depends: str, chosen: str
) -> None:
    assert _decided(tree, page, depends).ros_distro == chosen


def test_the_reason_names_what_the_newer_lacks(tree: Tree) -> None:
    found = _decided(tree, BOTH, "<depend>franka_description</depend>")
    why = next(each.reason for each in found.reasons if each.question == "ros_distro")
    assert why.endswith("; jazzy, which is named too, has no franka_description")


def test_what_is_cloned_speaks_against_none(tree: Tree) -> None:
    clone = "```\ngit clone https://github.com/frankaemika/franka_description\n```\n"
    assert _decided(tree, f"{BOTH}\n{clone}", "<depend>franka_description</depend>").ros_distro == "jazzy"
