"""Where a warning of the compiler counts as an error, the build goes on without it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

STRICT = "add_compile_options(-Wall -Werror)\n"
CATKIN = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "README.md": "ROS Noetic\n",
}
AMENT = {
    "package.xml": "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
    "README.md": "ROS 2 Humble\n",
}
PLAIN = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.16)\nproject(demo)\nadd_executable(demo demo.cpp)\n",
    "demo.cpp": "int main() {}\n",
}


@pytest.mark.parametrize(
    ("files", "line"),
    [
        (CATKIN, "reuse-build warnings-pass src headers-first catkin_make "),
        (
            CATKIN | {"README.md": "ROS Noetic\n```\ncatkin build\n```\n"},
            "warnings-pass src headers-first catkin build ",
        ),
        (AMENT, "reuse-build warnings-pass src colcon build "),
        (PLAIN, "warnings-pass /home/${NB_USER}/"),
    ],
)
@pytest.mark.parametrize(
    ("text", "strict"),
    [
        (STRICT, True),
        ("set(CMAKE_COMPILE_WARNING_AS_ERROR ON)\n", True),
        ("# add_compile_options(-Werror)\n", False),
        ("add_compile_options(-Wall -Wno-error)\n", False),
        ("set(CMAKE_COMPILE_WARNING_AS_ERROR OFF)\n", False),
    ],
)
def test_of_the_tree(tmp_path: Path, files: dict[str, str], line: str, text: str, strict: bool) -> None:
    tree_of(tmp_path, files | {"CMakeLists.txt": files["CMakeLists.txt"] + text})
    made = dockerfile(plan_repository(tmp_path).plan)
    assert (line in made) is strict
    assert ("/warnings-pass" in made) is strict


@pytest.mark.parametrize("folder", ["test", "examples"])
def test_what_is_no_part_of_it_has_no_say(tmp_path: Path, folder: str) -> None:
    tree_of(tmp_path, CATKIN | {f"{folder}/CMakeLists.txt": f"project(tests)\n{STRICT}"})
    assert "warnings-pass" not in dockerfile(plan_repository(tmp_path).plan)


def test_of_what_is_cloned_nothing_is_known(tmp_path: Path) -> None:
    listed = "- git: {local-name: acme, uri: 'https://github.com/acme/acme.git', version: main}\n"
    manifest = CATKIN["package.xml"].replace("</package>", "<depend>acme</depend></package>")
    tree_of(tmp_path, CATKIN | {"package.xml": manifest, "a.rosinstall": listed})
    assert "plain-apart warnings-pass src headers-first catkin_make" in dockerfile(plan_repository(tmp_path).plan)


def test_so_it_is_with_libraries_that_are_compiled_before_it(tmp_path: Path) -> None:
    tree_of(tmp_path, PLAIN | {"CMakeLists.txt": PLAIN["CMakeLists.txt"] + "find_package(GTSAM REQUIRED)\n"})
    made = dockerfile(plan_repository(tmp_path).plan)
    assert " && warnings-pass /tmp/sources/gtsam make --jobs=" in made
