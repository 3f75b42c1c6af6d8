"""Parts of Qt 4 that lie in packages of their own."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


@pytest.mark.parametrize(
    ("ros", "parts", "packages"),
    [
        ("indigo", "QtCore QtGui", {"libqt4-dev"}),
        ("kinetic", "QtCore QtOpenGL QtWebKit", {"libqt4-dev", "libqt4-opengl-dev", "libqtwebkit-dev"}),
        ("melodic", "QtCore QtOpenGL", {"libqt4-dev", "libqt4-opengl-dev"}),
    ],
)
def test_each_part_brings_its_package(tree: Tree, ros: str, parts: str, packages: set[str]) -> None:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nfind_package(Qt4 REQUIRED COMPONENTS {parts})\n"
    decision = tree({"package.xml": PACKAGE, "CMakeLists.txt": cmake, "README.md": f"ROS {ros.title()}\n"})
    assert decision.ros_distro == ros
    assert {name for name in decision.apt if "qt" in name} == packages
