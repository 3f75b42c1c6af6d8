"""Of nodes that no page runs and no launch file starts, the one that is named like its package is the program."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def package(name: str, *programs: str) -> dict[str, str]:
    made = "".join(f"add_executable({program} a.cpp)\n" for program in programs)
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>",
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED)\n{made}",
        f"{name}/a.cpp": "int main() {}\n",
    }


@pytest.mark.parametrize(
    ("programs", "meant"),
    [
        (("check_frames", "arm_servo_node"), "arm_servo_node"),
        (("arm_servo", "arm_offline"), "arm_servo"),
        (("ArmServo", "arm_offline"), "ArmServo"),
        (("arm_servo", "arm_servo_node"), ""),
        (("arm_servo_offline", "check_frames"), ""),
    ],
)
def test_the_node_named_like_its_package(tree: Tree, programs: tuple[str, ...], meant: str) -> None:
    command = tree(package("arm_servo", *programs)).command
    assert command == (("rosrun", "arm_servo", meant) if meant else ("bash",))


def test_not_where_another_package_has_nodes(tree: Tree) -> None:
    files = package("arm_servo", "arm_servo_node", "check_frames")
    assert tree(files | package("camera", "grab")).command == ("bash",)


def test_not_where_launch_files_start_them(tree: Tree) -> None:
    files = package("arm_servo", "arm_servo_node", "check_frames")
    node = '<launch><node pkg="arm_servo" type="arm_servo_node" name="a"/></launch>'
    launched = {f"arm_servo/launch/{name}.launch": node for name in ("one", "two")}
    assert tree(files | launched).command == ("bash",)
