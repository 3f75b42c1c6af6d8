"""Distributions in the names of files: a robot may be called like one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>{0}</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>"
)


@pytest.mark.parametrize(
    ("package", "file", "distro"),
    [
        ("iron_x", "joint_names_IRON-X v.1.yaml", "foxy"),
        ("iron_x", "start_iron.sh", "foxy"),
        ("driver", "params_iron.yaml", "iron"),
        ("iron_x", "Dockerfile.iron", "iron"),
        ("foxy_bot", "params_foxy.yaml", "foxy"),
    ],
)
def test_what_packages_are_called_by_is_the_robot_s_name(tree: Tree, package: str, file: str, distro: str) -> None:
    files = {
        "README.md": "# Robot\nUbuntu 20.04 ros2 foxy\n",
        f"{package}/package.xml": MANIFEST.format(package),
        f"{package}/CMakeLists.txt": f"project({package})\nfind_package(ament_cmake REQUIRED)\n",
        file: "FROM ros:iron\n" if file.startswith("Dockerfile") else "a: 1\n" if file.endswith(".yaml") else "",
    }
    assert tree(files).ros_distro == distro
