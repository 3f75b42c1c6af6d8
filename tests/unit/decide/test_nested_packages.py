"""Packages inside another package, which no build tool finds, are not built, and what is in them brings nothing."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FOLDER = "arm/sdk/ros/dynamixel_sdk"
NODE = "import rospy\nfrom dynamixel_sdk import *\nif __name__ == '__main__':\n    rospy.init_node('a')\n"


def package(folder: str, *needed: str, cmake: str = "", tool: str = "catkin") -> dict[str, str]:
    name = folder.rpartition("/")[2]
    depends = "".join(f"<depend>{each}</depend>" for each in needed)
    build_type = "" if tool == "catkin" else f"<export><build_type>{tool}</build_type></export>"
    xml = f"<package><name>{name}</name><buildtool_depend>{tool}</buildtool_depend>{depends}{build_type}</package>"
    return {
        f"{folder}/package.xml": xml,
        f"{folder}/CMakeLists.txt": f"project({name})\nfind_package({tool} REQUIRED)\n{cmake}",
    }


def inner(folder: str = FOLDER, tool: str = "catkin") -> dict[str, str]:
    return {
        **package(folder, "sound_play", "acme_msgs", cmake="find_package(OpenCV REQUIRED)\n", tool=tool),
        f"{folder}/n.cpp": "#include <pcl/pcl_base.h>\n#include <acme_msgs/A.h>\n",
        f"{folder}/src/dynamixel_sdk/__init__.py": "import torch\n",
        f"{folder}/launch/n.launch": '<launch><node pkg="dynamixel_sdk" type="n" name="n"/><node pkg="joy" type="j" '
        'name="j"/></launch>',
        f"{folder}/README.md": "```\nroslaunch dynamixel_sdk n.launch\nsudo apt install libzbar-dev\n```\n",
    }


@pytest.mark.parametrize("page", ["ROS Noetic\n", "ROS Noetic\nMade with dynamixel_sdk.\n"])
def test_it_is_not_built_and_brings_nothing(tree: Tree, page: str) -> None:
    decision = tree({**package("arm", "rospy"), **inner(), "arm/scripts/a.py": NODE, "README.md": page})
    assert decision.packages == ("arm/package.xml",)
    assert decision.command == ("bash",)
    assert not {"sound_play", "acme_msgs"} & {*decision.rosdep}
    brought = {*decision.apt, *decision.apt_guessed}
    assert not {"libopencv-dev", "libpcl-dev", "libzbar-dev", "ros-noetic-joy"} & brought
    assert "ros-noetic-dynamixel-sdk" in brought
    (told,) = [each for each in decision.warnings if "inside another package" in each.message]
    assert FOLDER in told.message
    assert not [each for each in decision.warnings if "acme_msgs" in each.message]


@pytest.mark.parametrize(
    "outer",
    [
        package("arm", cmake="add_subdirectory(sdk/ros/dynamixel_sdk)\n"),
        package("arm", cmake="add_subdirectory(sdk)\n"),
        package("arm", cmake="include_directories(${SDK}/dynamixel_sdk)\n"),
        package("arm", cmake="file(GLOB_RECURSE code *.cpp)\n"),
        {"arm/README.md": "```\ncd sdk/ros/dynamixel_sdk\nmkdir build\n```\n"},
        {"arm/build.sh": "cd sdk/ros\ncd dynamixel_sdk && make\n"},
        {"arm/scripts/b.py": "import sys\nsys.path.append('../sdk/ros/dynamixel_sdk/src')\n"},
    ],
)
def test_what_the_outer_one_names_is_read(tree: Tree, outer: dict[str, str]) -> None:
    decision = tree({**package("arm", "rospy"), **inner(), "README.md": "ROS Noetic\n", **outer})
    assert not [each for each in decision.warnings if "inside another package" in each.message]
    assert "libopencv-dev" in {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(
    "outer",
    [
        "# add_subdirectory(sdk)\n",
        "include_directories(src)\n",
        "install(PROGRAMS sdk/a.py DESTINATION bin)\n",
        "find_package(dynamixel_sdk REQUIRED)\n",
    ],
)
def test_what_is_beside_it_names_it_not(tree: Tree, outer: str) -> None:
    decision = tree({**package("arm", "rospy", cmake=outer), **inner(), "README.md": "ROS Noetic\n"})
    assert [each for each in decision.warnings if "inside another package" in each.message]


@pytest.mark.parametrize(
    ("files", "built"),
    [
        (package("arm", tool="ament_cmake") | inner(tool="ament_cmake"), ("arm/package.xml",)),
        # A package.xml alone is none that a build tool takes, and one that is marked hides only itself
        ({"arm/package.xml": package("arm")["arm/package.xml"]} | inner(), (f"{FOLDER}/package.xml",)),
        (package("arm") | inner("hand/dynamixel_sdk"), ("arm/package.xml", "hand/dynamixel_sdk/package.xml")),
    ],
)
def test_which_packages_are_inside_another(tree: Tree, files: dict[str, str], built: tuple[str, ...]) -> None:
    ros = "ROS 2 humble\n" if "ament" in files["arm/package.xml"] else "ROS Noetic\n"
    assert tree({**files, "README.md": ros}).packages == built


def test_a_key_of_its_name_is_no_longer_the_tree_s(tree: Tree) -> None:
    decision = tree({**package("arm", "dynamixel_sdk"), **inner(), "README.md": "ROS Noetic\n"})
    assert "dynamixel_sdk" in decision.rosdep


@pytest.mark.parametrize(("folder", "own"), [("bindings/python", True), ("sdk/python", False)])
def test_a_copied_project_in_a_package_is_not_on_python_s_path(tree: Tree, folder: str, own: bool) -> None:
    project = {
        f"arm/{folder}/setup.py": "import setuptools\nsetuptools.setup(name='a', packages=['dynamixel_sdk'])\n",
        f"arm/{folder}/dynamixel_sdk/__init__.py": "",
    }
    decision = tree({**package("arm", "rospy"), **project, "arm/scripts/a.py": NODE, "README.md": "ROS Noetic\n"})
    assert ("ros-noetic-dynamixel-sdk" not in {*decision.apt, *decision.apt_guessed}) == own


ACME = "arm/acme_msgs"


@pytest.mark.parametrize("tool", ["ament_cmake", "ament_python"])
def test_what_a_package_of_ros_2_needs_is_built_inside_it(tree: Tree, tool: str) -> None:
    """colcon is told of it: no distribution released what is called so, and nothing else can have brought it."""
    outer = package("arm", "acme_msgs", tool=tool) | {
        "arm/setup.py": "from setuptools import setup\nsetup(name='arm')\n"
    }
    inside = package(ACME, "acme_types", tool="ament_cmake") | package("arm/acme_types", tool="ament_cmake")
    decision = tree({**outer, **inside, **package("arm/other", tool="ament_cmake"), "README.md": "ROS 2 humble\n"})
    assert decision.packages == (f"{ACME}/package.xml", "arm/acme_types/package.xml", "arm/package.xml")
    assert decision.hidden == (ACME, "arm/acme_types")
    assert not {"acme_msgs", "acme_types"} & {*decision.rosdep}
    assert [each.reason for each in decision.reasons if "none inside another" in each.reason] == [
        "another package of the repository needs it: colcon is told of it, which looks for none inside another package"
    ] * 2
    (told,) = [each.message for each in decision.warnings if "inside another package" in each.message]
    assert told.endswith("arm/other")


@pytest.mark.parametrize("told", ["--base-paths src/repo/arm src/repo/arm/panel", "--base-paths=src/repo/arm/panel/"])
def test_what_a_page_tells_colcon_of_is_built(tree: Tree, told: str) -> None:
    page = f"ROS 2 humble\n```\ncolcon build {told} --symlink-install arm/other\n```\n"
    inside = package("arm/panel", tool="ament_cmake") | package("arm/other", tool="ament_cmake")
    decision = tree({**package("arm", tool="ament_cmake"), **inside, "README.md": page})
    assert (decision.package_names, decision.hidden) == (("arm", "panel"), ("arm/panel",))
    assert any(each.reason.startswith("a page tells colcon of its folder") for each in decision.reasons)


@pytest.mark.parametrize(
    ("outer", "folder", "inside"),
    [
        (package("arm", "sound_play", tool="ament_cmake"), "arm/sound_play", {}),
        (package("arm", tool="ament_cmake"), ACME, {}),
        (package("arm", "acme_msgs", tool="ament_cmake"), ACME, {f"{ACME}/COLCON_IGNORE": ""}),
        (package("arm", "acme_msgs", cmake="add_subdirectory(acme_msgs)\n", tool="ament_cmake"), ACME, {}),
        (package("arm", "acme_msgs", tool="ament_cmake") | package("acme_msgs", tool="ament_cmake"), ACME, {}),
    ],
    ids=["released", "not needed", "marked", "added", "beside"],
)
def test_what_else_is_inside_is_not(tree: Tree, outer: dict[str, str], folder: str, inside: dict[str, str]) -> None:
    decision = tree({**outer, **package(folder, tool="ament_cmake"), **inside, "README.md": "ROS 2 humble\n"})
    assert decision.hidden == ()


def test_catkin_is_told_of_none(tree: Tree) -> None:
    decision = tree({**package("arm", "acme_msgs"), **package(ACME), "README.md": "ROS Noetic\n"})
    assert (decision.packages, decision.hidden) == (("arm/package.xml",), ())
