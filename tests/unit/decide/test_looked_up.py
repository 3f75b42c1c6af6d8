"""A package whose folder a compiled program looks for is needed, though no manifest names it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>{}</buildtool_depend></package>"
OLD = 'ros::package::getPath("lab_maps")'
NEW = 'ament_index_cpp::get_package_share_directory("lab_maps")'
PAGE = "# Demo\n\n## ROS dependencies\n\n1. [ROS](https://www.ros.org/)\n1. [Maps](https://github.com/lab/lab_maps)\n"
CI = (
    "jobs:\n  a:\n    steps:\n      - run: |\n          git clone https://github.com/lab/lab_maps.git\n          make\n"
)


def files(code: str, tool: str = "catkin") -> dict[str, str]:
    cmake = f"project(demo)\nfind_package({tool} REQUIRED)\nadd_executable(demo src/a.cpp)\n"
    return {
        "package.xml": PACKAGE.format(tool),
        "CMakeLists.txt": cmake + ("catkin_package()\n" if tool == "catkin" else "ament_package()\n"),
        "src/a.cpp": f"{code}\nint main() {{}}\n",
    }


@pytest.mark.parametrize(
    ("code", "tool", "others", "cloned"),
    [
        (f"auto maps = {OLD};", "catkin", {"README.md": PAGE}, True),
        (f"auto maps = {NEW};", "ament_cmake", {"README.md": PAGE}, True),
        (f"auto maps = {OLD};", "catkin", {".github/workflows/a.yml": CI}, True),
        (f"// auto maps = {OLD};", "catkin", {"README.md": PAGE}, False),
        ("auto maps = ros::package::getPath(name);", "catkin", {"README.md": PAGE}, False),
        (f"auto maps = {OLD};", "catkin", {"README.md": "# Demo\n\nROS Noetic\n"}, False),
        (
            f"auto own = {OLD.replace('lab_maps', 'demo')};",
            "catkin",
            {"README.md": PAGE.replace("_maps", "_demo")},
            False,
        ),
    ],
)
def test_what_a_page_lists_or_ci_clones_is_cloned(
    tree: Tree, code: str, tool: str, others: dict[str, str], *, cloned: bool
) -> None:
    found = tree({**files(code, tool), **others})
    assert bool(found.source) is cloned


def test_what_is_released_comes_from_apt(tree: Tree) -> None:
    code = OLD.replace("lab_maps", "turtlebot3_description")
    found = tree({**files(f"auto robot = {code};"), "README.md": "ROS Noetic\n"})
    assert "ros-noetic-turtlebot3-description" in found.apt_guessed
