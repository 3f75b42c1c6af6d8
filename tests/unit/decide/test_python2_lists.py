"""A list that is for Python 2 by its name is installed without its versions where ROS's own Python is 3."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = """\
<package><name>planner</name><version>1.0.0</version><description>x</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<buildtool_depend>catkin</buildtool_depend><depend>rospy</depend></package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject(planner)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
LINES = "numpy\nCython==0.22.0\nscs>=1.1,<2\n"


def _decided(tree: Tree, name: str, ros: str) -> Decision:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "README.md": f"For ROS {ros}.\n", name: LINES}
    return tree({**files, "scripts/plan.py": "#!/usr/bin/env python\nimport rospy\nimport scs\n"})


@pytest.mark.parametrize(
    ("name", "ros", "loose"),
    [
        ("planner_requirements2.7.txt", "Noetic", True),
        ("requirements_py27.txt", "Noetic", True),
        ("requirements-python2.txt", "Noetic", True),
        ("planner_requirements2.7.txt", "Melodic", False),
        ("requirements2.txt", "Noetic", False),
        ("requirements-numpy2.txt", "Noetic", False),
        ("requirements-py2neo.txt", "Noetic", False),
        ("requirements-torch2.7.txt", "Noetic", False),
        ("requirements.txt", "Noetic", False),
    ],
)
def test_its_versions_give_way(tree: Tree, name: str, ros: str, *, loose: bool) -> None:
    decision = _decided(tree, name, ros)
    assert decision.ros_distro == ros.lower()
    assert decision.python.requirements == (() if loose else (name,))
    assert [each.written for each in decision.python.pip] == (["numpy", "Cython", "scs"] if loose else [])
    told = [each.message for each in decision.warnings if "is for Python 2 by its name" in each.message]
    why = f"{name} is for Python 2 by its name, and the image has 3.8"
    assert told == ([f"{why}: its packages are installed in releases that run there"] if loose else [])
