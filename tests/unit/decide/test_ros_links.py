"""Packages of ROS that the items of a list of prerequisites link to."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
PLUGINS = "https://index.ros.org/p/octomap_rviz_plugins/github-OctoMap-octomap_rviz_plugins/"
NAME = "ros-noetic-octomap-rviz-plugins"


@pytest.mark.parametrize(
    ("page", "found"),
    [
        (f"Ensure that the following prerequisites are installed:\n * OctoMap ([plugins]({PLUGINS}))\n", True),
        (f"## Dependencies\n\n- [plugins]({PLUGINS})\n", True),
        ("## Dependencies\n\n- [plugins](http://wiki.ros.org/octomap_rviz_plugins)\n", True),
        ("## Dependencies\n\n- [plugins](http://wiki.ros.org/octomap_rviz_plugins/Tutorials)\n", False),
        (f"## Optional dependencies\n\n- [plugins]({PLUGINS})\n", False),
        (f"## Dependencies\n\n- [plugins]({PLUGINS}), if you have no others\n", False),
        (f"## Related work\n\n- [plugins]({PLUGINS})\n", False),
        (f"As [plugins]({PLUGINS}) does.\n", False),
    ],
)
def test_the_links_of_a_list_of_prerequisites(tree: Tree, page: str, found: bool) -> None:
    assert (NAME in tree({**PACKAGE, "README.md": f"# Demo\n\nROS Noetic\n\n{page}"}).apt_guessed) is found


def test_what_the_distribution_has_not_is_not_asked_for(tree: Tree) -> None:
    page = "# Demo\n\nROS Noetic\n\n## Dependencies\n\n- [rviz2](https://index.ros.org/p/rviz2/)\n"
    decision = tree({**PACKAGE, "README.md": page})
    assert not any("rviz2" in name for name in (*decision.apt, *decision.apt_guessed))
