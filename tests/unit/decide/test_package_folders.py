"""Lists of requirements in the folders of ROS packages."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision


@pytest.mark.parametrize(
    ("path", "installed"),
    [
        ("ros_packages/web_gui/requirements.txt", True),
        ("ros_packages/web_gui/scripts/requirements.txt", True),
        ("ros_packages/requirements.txt", True),
        ("ros_packages/web_gui/requirements_gpu.txt", False),  # the list's own name tells that it is for one use
        ("web_demo/requirements.txt", False),  # no package is there
    ],
)
def test_the_folder_of_a_package_tells_no_use(
    tree: Callable[[dict[str, str]], Decision], path: str, installed: bool
) -> None:
    """``ros_packages`` and ``web_gui`` begin like names of lists for one use of several."""
    export = "<export><build_type>ament_cmake</build_type></export>"
    package = {
        "package.xml": f"<package format='3'><name>web_gui</name><depend>rclpy</depend>{export}</package>",
        "CMakeLists.txt": "project(web_gui)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
    }
    decision = tree({f"ros_packages/web_gui/{name}": text for name, text in package.items()} | {path: "six\n"})
    assert decision.kind == "ros2"
    assert decision.python.requirements == ((path,) if installed else ())
