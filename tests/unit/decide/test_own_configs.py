"""A project of plain CMake that a package finds by its name is compiled and installed before the workspace."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LIBRARY = (
    "project(grip VERSION 1.0)\nadd_library(grip a.cpp)\ninstall(TARGETS grip EXPORT t)\n"
    "install(EXPORT t FILE {} DESTINATION lib/cmake/grip)\n"
)
FILES = {
    "README.md": "ROS Noetic\n",
    "lib/CMakeLists.txt": LIBRARY.format("${PROJECT_NAME}-config.cmake"),
    "grip_ros/package.xml": (
        "<package><name>grip_ros</name><buildtool_depend>catkin</buildtool_depend><depend>{}</depend></package>"
    ).format("grip"),
    "grip_ros/CMakeLists.txt": "project(grip_ros)\nfind_package(catkin REQUIRED)\nfind_package(grip REQUIRED)\n",
    ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/grip_all.git\n',
}
OF_ROS_2 = {
    "README.md": "ROS 2 Humble\n",
    "grip_ros/package.xml": (
        "<package format='3'><name>grip_ros</name><buildtool_depend>ament_cmake</buildtool_depend>"
        "<depend>grip</depend><export><build_type>ament_cmake</build_type></export></package>"
    ),
}
DECLARED = FILES["lib/CMakeLists.txt"]


@pytest.mark.parametrize(
    ("files", "folders"),
    [
        ({}, ["lib"]),
        ({"lib/CMakeLists.txt": LIBRARY.format("gripTargets.cmake")}, []),  # nothing finds it
        ({"lib/CMakeLists.txt": DECLARED.replace("project(grip ", "project(Eigen3 ")}, []),
        ({"lib/CMakeLists.txt": "", "CMakeLists.txt": DECLARED}, [""]),
        ({"lib/CMakeLists.txt": "project(grip)\nadd_subdirectory(src)\n", "lib/src/CMakeLists.txt": DECLARED}, ["lib"]),
        ({"grip_ros/CMakeLists.txt": "project(grip_ros)\nfind_package(catkin REQUIRED)\n"}, []),
        ({"lib/package.xml": FILES["grip_ros/package.xml"].replace("grip_ros", "grip")}, []),
        (OF_ROS_2, []),  # colcon builds it
    ],
)
def test_it_is_installed_where_a_package_requires_it(tree: Tree, files: dict[str, str], folders: list[str]) -> None:
    found = tree(FILES | files)
    assert [script.folder for script in found.scripts] == folders
    assert all(script.command.endswith("install && ldconfig") for script in found.scripts)


@pytest.mark.parametrize(("call", "stops"), [("{}", True), ("if(WITH_GRIP)\n{}endif()\n", False)])
def test_the_build_stops_where_it_fails_and_a_package_cannot_do_without(tree: Tree, call: str, stops: bool) -> None:
    asks = call.format("find_package(grip REQUIRED)\n")
    found = tree({**FILES, "grip_ros/CMakeLists.txt": f"project(grip_ros)\nfind_package(catkin REQUIRED)\n{asks}"})
    assert [script.required for script in found.scripts] == [True] * stops


LINKED = {
    "lib/CMakeLists.txt": (
        "project(grip)\nadd_library(grip_core SHARED a.cpp)\ninstall(TARGETS grip_core DESTINATION lib)\n"
    ),
    "lib/a.cpp": "int a() { return 1; }\n",
    "grip_ros/n.cpp": "int main() { return 0; }\n",
    "grip_ros/CMakeLists.txt": (
        "project(grip_ros)\nfind_package(catkin REQUIRED)\nfind_package(grip)\nadd_executable(n n.cpp)\n"
        "target_link_libraries(n grip_core)\n"
    ),
}
PACKAGE = LINKED["grip_ros/CMakeLists.txt"]


@pytest.mark.parametrize(
    ("files", "folders"),
    [
        ({}, ["lib"]),
        ({"lib/CMakeLists.txt": "project(grip)\nadd_library(grip_core SHARED a.cpp)\n"}, []),  # nobody finds it
        ({"lib/CMakeLists.txt": LINKED["lib/CMakeLists.txt"].replace("grip_core", "yaml-cpp")}, []),
        ({"grip_ros/CMakeLists.txt": PACKAGE.replace("target_link", "#target_link")}, []),
        ({"grip_ros/CMakeLists.txt": f"{PACKAGE}add_library(grip_core b.cpp)\n"}, []),
        ({"lib/package.xml": FILES["grip_ros/package.xml"].replace("grip_ros", "grip")}, []),
        ({"examples/lib/CMakeLists.txt": LINKED["lib/CMakeLists.txt"], "lib/CMakeLists.txt": ""}, []),
        (OF_ROS_2, []),
    ],
)
def test_so_it_is_where_a_package_names_its_library_alone(
    tree: Tree, files: dict[str, str], folders: list[str]
) -> None:
    found = tree(FILES | LINKED | files)
    assert [script.folder for script in found.scripts] == folders
    assert all(script.required for script in found.scripts)


def test_a_key_called_like_what_is_linked_is_looked_for_nowhere(tree: Tree) -> None:
    found = tree(FILES | LINKED)
    assert "grip" not in found.rosdep
    assert not found.source
    assert not any("grip" in warning.message for warning in found.warnings)


@pytest.mark.parametrize("files", [{}, OF_ROS_2])
def test_it_is_no_key_and_is_looked_for_nowhere(tree: Tree, files: dict[str, str]) -> None:
    found = tree(FILES | files)
    assert "grip" not in found.rosdep
    assert not found.source
    assert not any("grip" in warning.message for warning in found.warnings)


@pytest.mark.parametrize(
    ("cmake", "told"),
    [
        ("find_package(catkin REQUIRED COMPONENTS events)", "and where it is not there, catkin_make will stop"),
        ("find_package(catkin REQUIRED)", "and goes on"),
    ],
)
def test_a_key_that_cmake_requires_too_is_nothing_to_go_on_without(tree: Tree, cmake: str, told: str) -> None:
    files = {
        "README.md": "ROS Noetic\n",
        "package.xml": FILES["grip_ros/package.xml"].replace("<depend>grip<", "<depend>events<"),
        "CMakeLists.txt": f"project(grip_ros)\n{cmake}\n",
        ".git/config": FILES[".git/config"],
    }
    key = next(each.message for each in tree(files).warnings if " events" in each.message)
    assert f"looks for it in https://github.com/lab/events, {told} " in key


def test_it_has_the_options_of_the_page(tree: Tree) -> None:
    cmake = "cmake .. -DWITH_GUI=OFF -DCMAKE_INSTALL_PREFIX=/opt/grip"
    page = f"ROS Noetic\n```\ncd lib\nmkdir build && cd build\n{cmake}\nmake\n```\n"
    (script,) = tree(FILES | {"README.md": page}).scripts
    assert "cmake -DCMAKE_BUILD_TYPE=Release -DWITH_GUI=OFF .. " in script.command
