"""Lines of apt in a section for another distribution, where the page has one for this one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
OURS = "## Ubuntu 16.04 with ROS Kinetic\n```\nsudo apt install libglog-dev\n```\n"


@pytest.mark.parametrize(
    ("title", "page", "installed"),
    [
        ("Ubuntu 18.04 with ROS Melodic and Gazebo 9", OURS, False),
        ("Ubuntu 18.04", OURS, False),
        ("Ubuntu 14.04 or newer", OURS, True),
        ("Ubuntu 16.04 and 18.04", OURS, True),
        ("Gazebo", OURS, True),
        ("Ubuntu 18.04", "## Packages\n```\nsudo apt install libglog-dev\n```\n", True),
    ],
)
def test_lines_for_another_ubuntu(tree: Tree, title: str, page: str, installed: bool) -> None:
    text = f"# Demo\nROS Kinetic is recommended\n{page}## {title}\n```\nsudo apt install gazebo9\n```\n"
    decision = tree({"package.xml": PACKAGE, "CMakeLists.txt": "project(demo)\n", "README.md": text})
    assert decision.ros_distro == "kinetic"
    assert ("gazebo9" in decision.apt_guessed) is installed
    assert "libglog-dev" in decision.apt_guessed
