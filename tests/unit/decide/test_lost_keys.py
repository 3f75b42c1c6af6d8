"""Where nothing names a distribution, the last that released what the packages need to be built is taken."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "```\ngit clone https://github.com/RethinkRobotics-opensource/sns_ik.git\n```\n"


@pytest.mark.parametrize(
    ("tag", "page", "distro"),
    [
        ("build_depend", "Hello", "kinetic"),
        ("run_depend", "Hello", "noetic"),
        ("build_depend", PAGE.replace("sns_ik.git", "sns_ik_lib.git"), "noetic"),
        ("build_depend", "ROS Melodic", "melodic"),
    ],
)
def test_a_package_that_only_an_older_distribution_released(tree: Tree, tag: str, page: str, distro: str) -> None:
    needs = f"<buildtool_depend>catkin</buildtool_depend><{tag}>sns_ik_lib</{tag}>"
    decision = tree(
        {
            "package.xml": f"<package><name>demo</name>{needs}</package>",
            "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
            "README.md": page,
        }
    )
    assert decision.ros_distro == distro
    assert any("is the last that released sns_ik_lib" in each.reason for each in decision.reasons) == (
        distro == "kinetic"
    )
