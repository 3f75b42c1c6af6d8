"""A branch that is called after the reader's distribution is that of the image's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TREE = {
    "package.xml": (
        "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>arms</depend></package>"
    ),
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
URL = "https://github.com/me/arms.git"


def ref(tree: Tree, line: str, said: str = "ROS Melodic") -> str | None:
    decision = tree({**TREE, "README.md": f"{said}\n```\ncd ws/src\n{line}\n```\n"})
    return next(source.ref for source in decision.source if source.name == "arms")


@pytest.mark.parametrize(
    ("line", "branch"),
    [
        (f"git clone {URL} --branch <YOUR_ROS_VERSION>-devel", "melodic-devel"),
        (f"git clone -b <ros-distro> {URL}", "melodic"),
        (f"git clone -b ${{ROS_DISTRO}}-devel {URL}", "melodic-devel"),
        (f'git clone --branch="$ROS_DISTRO" {URL}', "melodic"),
        (f"git clone -b devel/ROS_DISTRO {URL}", "devel/melodic"),
        (f"git clone {URL}\ncd arms\ngit checkout <distro>-devel", "melodic-devel"),
        (f"git clone -b <your-branch> {URL}", None),
        (f"git clone -b $BRANCH {URL}", None),
        (f"git clone -b kinetic-devel {URL}", "kinetic-devel"),
        (f"git clone -b version {URL}", "version"),
    ],
)
def test_a_blank_for_the_distribution(tree: Tree, line: str, branch: str | None) -> None:
    assert ref(tree, line) == branch


def test_it_tells_no_distribution_itself(tree: Tree) -> None:
    assert ref(tree, f"git clone -b <YOUR_ROS_VERSION>-devel {URL}", "ROS Kinetic") == "kinetic-devel"
