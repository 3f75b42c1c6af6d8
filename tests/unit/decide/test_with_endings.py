"""A page may leave out the ending by which alone `ros2 run` and `rosrun` find a program."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MANIFEST = (
    '<package format="3"><name>demo</name><buildtool_depend>{0}</buildtool_depend>'
    "<export><build_type>{0}</build_type></export></package>"
)
NODE = "#!/usr/bin/env python3\nimport rclpy\nif __name__ == '__main__':\n    rclpy.init()\n"
INSTALLS = "install(PROGRAMS scripts/talker.py DESTINATION lib/demo)\n"


def command(tree: Tree, said: str, cmake: str, build: str = "ament_cmake") -> tuple[str, ...] | str:
    return tree(
        {
            "README.md": f"# ROS 2 Humble\n\n## Usage\n```bash\n{said}\n```\n",
            "demo/package.xml": MANIFEST.format(build),
            "demo/CMakeLists.txt": f"project(demo)\nfind_package({build} REQUIRED)\n{cmake}",
            "demo/scripts/talker.py": NODE,
        }
    ).command


@pytest.mark.parametrize(
    ("said", "cmake", "found"),
    [
        ("ros2 run demo talker", INSTALLS, "ros2 run demo talker.py"),
        ("ros2 run demo talker --rate 2", INSTALLS, "ros2 run demo talker.py --rate 2"),
        ("ros2 run demo talker.py", INSTALLS, "ros2 run demo talker.py"),
        ("ros2 run demo talker", f"# {INSTALLS}", "ros2 run demo talker"),
        ("ros2 run demo talker", f"{INSTALLS}add_executable(talker a.cpp)\n", "ros2 run demo talker"),
        ("ros2 run demo talker", INSTALLS.replace("demo)", "demo RENAME ${NAME})"), "ros2 run demo talker"),
        ("ros2 run demo talker", f"{INSTALLS}# install(CODE 'create_symlink')\n", "ros2 run demo talker.py"),
        ("ros2 run demo talker", f"{INSTALLS}install(CODE 'create_symlink')\n", "ros2 run demo talker"),
        ("ros2 run demo talk", INSTALLS, "ros2 run demo talk"),
    ],
)
def test_the_ending_is_that_by_which_cmake_installs_it(tree: Tree, said: str, cmake: str, found: str) -> None:
    assert command(tree, said, cmake) == tuple(found.split())


def test_it_is_so_in_ros_1(tree: Tree) -> None:
    installs = "catkin_install_python(PROGRAMS scripts/talker.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"
    files = {
        "README.md": "# ROS Noetic\n\n## Usage\n```bash\nroscore &\nrosrun demo talker\n```\n",
        "demo/package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "demo/CMakeLists.txt": f"project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n{installs}",
        "demo/scripts/talker.py": NODE.replace("rclpy", "rospy"),
    }
    assert "talker.py" in str(tree(files).command)
