"""Nodes whose first line starts Python 2 by its number run on the distribution's Python 2, and pip is that one's."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}


@pytest.mark.parametrize(
    ("first", "distro", "version"),
    [
        ("#!/usr/bin/env python2.7", "melodic", "2.7"),
        ("#!/usr/bin/python2", "kinetic", "2.7"),
        ("#!/usr/bin/env python3", "melodic", None),
        ("# python2.7", "melodic", None),
        ("#!/usr/bin/env python2.7", "noetic", None),
    ],
)
def test_the_number_counts_where_ros_has_that_python(tree: Tree, first: str, distro: str, version: str | None) -> None:
    page = {"README.md": f"    source /opt/ros/{distro}/setup.bash\n"}
    found = tree({**PACKAGE, **page, "scripts/a.py": f"{first}\nimport rospy\nimport numpy\n"})
    assert found.ros_distro == distro
    assert (found.python.version == "2.7") is (version == "2.7")


def test_what_is_no_node_says_nothing(tree: Tree) -> None:
    page = {"README.md": "    source /opt/ros/melodic/setup.bash\n"}
    tool = {"tools/a.py": "#!/usr/bin/env python2\nimport numpy\n"}
    assert tree({**PACKAGE, **page, **tool}).python.version != "2.7"


def test_beside_a_node_of_python_3_it_says_nothing(tree: Tree) -> None:
    page = {"README.md": "    source /opt/ros/melodic/setup.bash\n"}
    nodes = {f"scripts/{n}.py": f"#!/usr/bin/env python{n}\nimport rospy\nimport numpy\n" for n in (2, 3)}
    assert tree({**PACKAGE, **page, **nodes}).python.version != "2.7"
