"""A repository that the tree or a table names by what is missing is cloned in the next round."""

from __future__ import annotations

from pathlib import Path

import pytest

from failed_builds import log, repaired
from roslab.config.addition import added
from roslab.config.reader import read

PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>
</package>
"""
ROS = {"package.xml": PACKAGE, "CMakeLists.txt": "project(robot)\n", "roslab.yaml": "format: 3\nbase: {ros: noetic}\n"}
CPP = {"CMakeLists.txt": "project(robot CXX)\nadd_executable(robot main.cpp)\n", "main.cpp": "int main() {}\n"}
PYTHON = {"requirements.txt": "numpy\n", "main.py": "import numpy\n"}

PAGE = """\
# robot

The arm comes from [robot_arm](https://github.com/example/robot_arm), and its camera from a private repository.

```
git clone -b noetic https://github.com/example/arm_driver.git
```
"""
NO_ARM = (
    "-- Could not find the required component 'robot_arm'. The following CMake error indicates that",
    "CMake Error at /opt/ros/noetic/share/catkin/cmake/catkinConfig.cmake:83 (find_package):",
)
NO_HEADER = "/home/jovyan/ws/src/robot/src/a.cpp:3:10: fatal error: {}: No such file or directory"
NO_MODULE = "ModuleNotFoundError: No module named 'arm_driver'"
ARM = "source: [{name: robot_arm, repo: https://github.com/example/robot_arm, build: catkin_make}]"
DRIVER = (
    "source: [{name: arm_driver, repo: https://github.com/example/arm_driver.git, ref: noetic, build: catkin_make}]"
)


@pytest.mark.parametrize(
    ("files", "text", "wanted"),
    [
        (ROS, log("catkin_make", *NO_ARM), [ARM]),
        (ROS, log("catkin_make", NO_HEADER.format("arm_driver/arm.h")), [DRIVER]),
        (ROS, log("catkin_make", NO_HEADER.format("pluginlib/class_loader.h")), ["apt: [ros-noetic-pluginlib]"]),
        (ROS, log("catkin_make", NO_HEADER.format("nav_core/arm.h")), ["apt: [ros-noetic-nav-core]"]),
        (
            {**ROS, "roslab.yaml": "format: 3\nbase: {ros: humble}\n"},
            log(
                "colcon build", "ld: /opt/ros/humble/lib/librclcpp.so: undefined reference to `rcl_clock_time_started'"
            ),
            ["apt: [ros-humble-rcl]"],
        ),
        (ROS, log("catkin_make", NO_HEADER.format("other_driver/arm.h")), []),
        (ROS, "Traceback (most recent call last):\n" + NO_MODULE + "\n", [DRIVER]),
        (PYTHON, log("python3 main.py", NO_MODULE), ["pip: [git+https://github.com/example/arm_driver.git@noetic]"]),
        (
            CPP,
            log("make", NO_HEADER.format("arm_driver/arm.h")),
            [DRIVER.replace("catkin_make", "cmake")],
        ),
    ],
)
def test_what_a_log_lacks_is_cloned_from_where_the_tree_says(
    tmp_path: Path, files: dict[str, str], text: str, wanted: list[str]
) -> None:
    found = repaired(tmp_path, text, {**files, "README.md": PAGE})
    assert [str(change) for change in found.certain.changes] == wanted


@pytest.mark.parametrize("page", ["git clone git@{}", "git clone ssh://git@{}"])
def test_a_build_has_no_key_for_ssh(tmp_path: Path, page: str) -> None:
    files = {"README.md": f"```\n{page}\n```\n".format("github.com/example/arm_driver.git")}
    found = repaired(tmp_path, log("python3 main.py", NO_MODULE), {**PYTHON, **files})
    assert [change.value for change in found.changes] == ["git+https://github.com/example/arm_driver.git"]
    found = repaired(tmp_path / "ros", log("catkin_make", NO_HEADER.format("arm_driver/arm.h")), {**ROS, **files})
    assert [str(change) for change in found.changes] == [DRIVER.replace("ref: noetic, ", "")]


def test_what_a_table_knows_is_cloned_with_its_needs(tmp_path: Path) -> None:
    said = "-- Could not find the required component 'minkindr_conversions'. The following CMake error indicates that"
    wanted = said.replace("minkindr_conversions", "eigen_catkin")
    found = repaired(tmp_path, log("catkin_make", wanted, NO_ARM[1]), ROS)
    assert [str(change)[:40] for change in found.certain.changes] == [
        "source: [{name: catkin_simple, repo: htt",
        "source: [{name: eigen_catkin, repo: http",
    ]
    assert repaired(tmp_path, log("catkin_make", said, NO_ARM[1])).changes == ()  # minkindr's checkout is changed first


def test_what_roslab_yaml_clones_already_is_not_cloned_again(tmp_path: Path) -> None:
    source = "source: [{name: arm, repo: 'https://github.com/example/arm_driver', build: catkin_make}]\n"
    files = {**ROS, "README.md": PAGE, "roslab.yaml": ROS["roslab.yaml"] + source}
    found = repaired(tmp_path, log("catkin_make", NO_HEADER.format("arm_driver/arm.h")), files)
    assert found.changes == ()


@pytest.mark.parametrize(
    ("files", "text"),
    [
        (ROS, log("catkin_make", NO_HEADER.format("robot_arm/arm.h"))),
        (ROS, log("python3 main.py", NO_MODULE.replace("arm_driver", "robot_arm"))),
        (PYTHON, log("python3 main.py", NO_MODULE.replace("arm_driver", "robot_arm"))),
    ],
)
def test_a_folder_or_a_module_of_a_linked_repository_s_name_is_likely(
    tmp_path: Path, files: dict[str, str], text: str
) -> None:
    found = repaired(tmp_path, text, {**files, "README.md": PAGE})
    assert [change.certain for change in found.changes] == [False]
    owned = {**files, "README.md": PAGE, ".git/config": '[remote "origin"]\n\turl = https://github.com/example/a.git\n'}
    assert [change.certain for change in repaired(tmp_path, text, owned).changes] == [True]


def test_a_header_of_the_tree_s_own_package_is_looked_for_nowhere_else(tmp_path: Path) -> None:
    page = PAGE.replace("robot_arm", "robot")
    found = repaired(tmp_path, log("catkin_make", NO_HEADER.format("robot/move.h")), {**ROS, "README.md": page})
    assert found.changes == ()
    own = {**ROS, "package.xml": PACKAGE.replace("<name>robot<", "<name>nav_core<")}
    assert repaired(tmp_path, log("catkin_make", NO_HEADER.format("nav_core/arm.h")), own).changes == ()


def test_what_ros_released_is_not_cloned(tmp_path: Path) -> None:
    page = PAGE.replace("example/robot_arm", "example/pluginlib")
    package = PACKAGE.replace("</buildtool_depend>", "</buildtool_depend><depend>pluginlib</depend>")
    found = repaired(
        tmp_path,
        log("catkin_make", NO_HEADER.format("pluginlib/class_loader.h")),
        {**ROS, "package.xml": package, "README.md": page},
    )
    assert found.changes == ()


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (None, "format: 3\nsource:\n  - "),
        ("format: 3\nsource: [{name: a, repo: 'https://example.org/a'}]\n", "a'}, "),
        ("format: 3\nsource:\n- name: a\n  repo: https://example.org/a\n", "/a\n- "),
    ],
)
def test_the_line_of_a_clone_is_added_and_read(tmp_path: Path, before: str | None, after: str) -> None:
    files = {**ROS, "README.md": PAGE}
    entries = repaired(tmp_path, log("catkin_make", NO_HEADER.format("arm_driver/arm.h")), files).entries
    text = added(before, entries)
    assert f"{after}{{name: arm_driver, " in text
    last = read(text).source[-1]
    assert (last.name, last.repo, last.ref, last.build) == (
        "arm_driver",
        "https://github.com/example/arm_driver.git",
        "noetic",
        "catkin_make",
    )
    assert added(text, entries) == text
