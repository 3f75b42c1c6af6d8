"""Packages of the tree that nothing can build although others of it need them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def _manifest(name: str, needed: str = "") -> str:
    return f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend>{needed}</package>"


def _files(components: str, *, built: bool = False) -> dict[str, str]:
    """Return a tree whose odometry requires what CMake of it names, beside a copy of a driver's package.xml."""
    cmake = f"project(odometry)\nfind_package(catkin REQUIRED COMPONENTS roscpp {components})\ncatkin_package()\n"
    files = {
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/slam\n',
        ".git/HEAD": "ref: refs/heads/a\n",
        "odometry/package.xml": _manifest("odometry", "<depend>quad_driver</depend>"),
        "odometry/CMakeLists.txt": cmake,
        "driver-master/quad_driver/package.xml": _manifest("quad_driver"),
        "driver-master/quad_driver/msg/A.msg": "int32 a\n",
    }
    if built:
        files["driver-master/quad_driver/CMakeLists.txt"] = "project(quad_driver)\nfind_package(catkin REQUIRED)\n"
    return files


@pytest.mark.parametrize(
    ("components", "built", "sought"),
    [("quad_driver", False, ["quad_driver"]), ("quad_driver", True, []), ("", False, [])],
)
def test_what_others_require_built_and_cannot_be_is_sought_elsewhere(
    tree: Tree, components: str, built: bool, sought: list[str]
) -> None:
    decision = tree(_files(components, built=built))
    assert [name for source in decision.source for name in source.holding] == sought
    warned = [warning for warning in decision.warnings if "that brings quad_driver" in warning.message]
    assert len(warned) == len(sought)


def test_what_a_table_knows_is_taken_from_there(tree: Tree) -> None:
    files = {
        path.replace("quad", "livox_ros"): text.replace("quad", "livox_ros")
        for path, text in _files("quad_driver").items()
    }
    assert "livox_ros_driver" in {source.name for source in tree(files).source}
