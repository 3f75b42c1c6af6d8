"""Keys that are pip's names, a build type, or packages of another distribution."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config, Source
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]


def _files(*keys: str) -> dict[str, str]:
    depends = "".join(f"<depend>{key}</depend>" for key in keys)
    return {
        "package.xml": f"<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>{depends}"
        "</package>",
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nament_package()\n",
        "README.md": "ROS 2 Jazzy\n",
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/demo\n',
        ".git/HEAD": "ref: refs/heads/a\n",
    }


@pytest.mark.parametrize(("key", "apt"), [("numpy", "python3-numpy"), ("opencv-python", "python3-opencv")])
def test_the_names_of_pip_are_ubuntus_packages(tree: Tree, key: str, apt: str) -> None:
    decision = tree(_files(key))
    assert apt in decision.apt_guessed
    assert key in decision.skip_keys
    assert [each.message for each in decision.warnings if f"{apt} is installed for it" in each.message]
    assert decision.source == ()


@pytest.mark.parametrize("key", ["cv-bridge", "ros-jazzy-cv-bridge", "ros-humble-cv-bridge"])
def test_a_package_as_apt_writes_it(tree: Tree, key: str) -> None:
    decision = tree(_files(key))
    assert "ros-jazzy-cv-bridge" in decision.apt_guessed
    assert key in decision.skip_keys
    said = f"{key} is no key of rosdep, cv_bridge is: ros-jazzy-cv-bridge is installed for it"
    assert [each.message for each in decision.warnings if each.message == said]


def test_a_name_with_dashes_that_no_package_has(tree: Tree) -> None:
    decision = tree(_files("cv-brigde"))
    assert not any("is installed for it" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("cmake", "code", "apt"),
    [
        ("find_package(pcl REQUIRED)\n", "", "libpcl-dev"),
        ("", "#include <pcl/point_types.h>\n", "libpcl-dev"),
        ("", "", "python3-pcl"),
    ],
)
def test_a_library_of_the_code_is_no_package_of_pip(tree: Tree, cmake: str, code: str, apt: str) -> None:
    files = _files("pcl")
    decision = tree({**files, "CMakeLists.txt": files["CMakeLists.txt"] + cmake, "src/a.cpp": code})
    assert {"libpcl-dev", "python3-pcl"} & {*decision.apt, *decision.apt_guessed} == {apt}
    assert [each.message for each in decision.warnings if f"{apt} is installed for it" in each.message]


def test_a_build_type_is_no_package(tree: Tree) -> None:
    decision = tree(_files("ament_python"))
    assert decision.skip_keys == ("ament_python",)
    assert [each.message for each in decision.warnings if "remove the dependency" in each.message]
    assert decision.source == ()


@pytest.mark.parametrize(
    ("key", "sought", "said"),
    [
        ("nav2_recoveries", [], "ROS galactic has a package of that name"),
        ("gazebo_ros_pkgs", [], "has a package of that name"),
        ("demo_acts", ["https://github.com/lab/demo_acts.git"], "the build looks for it"),
    ],
)
def test_what_another_distribution_has_is_not_the_owners(tree: Tree, key: str, sought: list[str], said: str) -> None:
    decision = tree(_files(key))
    assert [each.repo for each in decision.source] == sought
    assert any(said in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("target", "page", "looks"),
    [
        ("add_executable(robot_mover a.cpp)\n", "", []),
        ("add_library(robot_mover a.cpp)\n", "", []),
        ("add_executable(other a.cpp)\n", "", ["robot_mover"]),
        ("find_package(robot_mover REQUIRED)\nadd_executable(robot_mover a.cpp)\n", "", ["robot_mover"]),
        ("find_package(robot_lamp)\nadd_executable(robot_mover a.cpp)\n", "", []),
        ("add_executable(robot_mover a.cpp)\n", "It needs https://github.com/lab/robot_mover\n", ["robot_mover"]),
    ],
)
def test_a_program_of_the_package_itself_is_no_key(tree: Tree, target: str, page: str, looks: list[str]) -> None:
    files = _files("robot_mover")
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("ament_package", f"{target}ament_package")
    files["README.md"] += page
    decision = tree(files | {"a.cpp": "int main() {}\n"})
    assert [each.name for each in decision.source] == looks


def test_the_core_of_ros_1_is_left_over(tree: Tree) -> None:
    """No repository can hold it for ROS 2, whatever a page links to."""
    files = _files("roscpp", "message_generation", "catkin", "rclcpp", "acme_msgs")
    decision = tree({**files, "README.md": "ROS 2 Jazzy\n\nIt needs [core](https://github.com/lab/core).\n"})
    left = {"roscpp", "message_generation", "catkin"}
    assert left <= {*decision.skip_keys}
    told = [each.message for each in decision.warnings if "left over from ROS 1" in each.message]
    assert len(told) == 1
    assert all(name in told[0] for name in left)
    assert {name for source in decision.source for name in source.holding} == {"acme_msgs"}


def test_ros_1_has_its_core(tree: Tree) -> None:
    files = {**_files("roscpp", "message_generation"), "README.md": "ROS Noetic\n"}
    files["package.xml"] = files["package.xml"].replace("ament_cmake", "catkin")
    files["CMakeLists.txt"] = "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    decision = tree(files)
    assert decision.skip_keys == ()
    assert not [each.message for each in decision.warnings if "left over" in each.message]


@pytest.mark.parametrize(("own", "looks"), [(False, ["robot_mover"]), (True, [])])
def test_a_program_called_like_the_package_whose_headers_it_includes(tree: Tree, own: bool, looks: list[str]) -> None:
    files = _files("robot_mover")
    target = "include_directories(include)\nadd_executable(robot_mover a.cpp)\n"
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("ament_package", f"{target}ament_package")
    files["a.cpp"] = "#include <robot_mover/api.hpp>\nint main() {}\n"
    decision = tree(files | ({"include/robot_mover/api.hpp": ""} if own else {}))
    assert [each.name for each in decision.source] == looks


@pytest.mark.parametrize(
    ("config", "told"),
    [
        ("forward_position_controller:\n  type: forward_command_controller/ForwardCommandController\n", True),
        ("forward_position_controller:\n  ros__parameters:\n    type: forward_command_controller/X\n", False),
        ("other_controller:\n  type: forward_command_controller/ForwardCommandController\n", False),
    ],
)
def test_the_name_of_a_controller_is_no_package(tree: Tree, config: str, *, told: bool) -> None:
    decision = tree({**_files("forward_position_controller"), "config/controllers.yaml": f"# all\n{config}"})
    said = [each.message for each in decision.warnings if "is a controller of config/controllers.yaml" in each.message]
    assert bool(said) == told
    assert bool(decision.source) != told
    assert "ros-jazzy-forward-command-controller" in decision.apt_guessed or not told
    assert ("forward_position_controller" in decision.skip_keys) == told


@pytest.mark.parametrize(
    ("page", "sources"),
    [
        ("It needs [arm_controller](https://github.com/me/arm_controller).\n", ["arm_controller"]),
        (
            "```\ngit clone https://github.com/me/robot_stack\ngit clone https://github.com/lab/demo\n```\n",
            ["robot_stack"],
        ),
        ("```\ngit clone https://github.com/lab/demo\ncolcon build\n```\n", []),
    ],
)
def test_a_repository_may_have_a_package_that_is_called_like_a_controller(
    tree: Tree, page: str, sources: list[str]
) -> None:
    config = "arm_controller:\n  type: joint_trajectory_controller/JointTrajectoryController\n"
    page = f"ROS 2 Jazzy\n\n{page}"
    decision = tree({**_files("arm_controller"), "config/controllers.yaml": config, "README.md": page})
    assert [each.name for each in decision.source] == sources
    assert any("is a controller of" in each.message for each in decision.warnings) == (not sources)


def test_a_source_of_roslab_yaml_may_have_a_package_that_is_called_like_a_controller(tmp_path: Path) -> None:
    config = "arm_controller:\n  type: joint_trajectory_controller/JointTrajectoryController\n"
    files = {**_files("arm_controller"), "config/controllers.yaml": config}
    stack = Source(name="stack", repo="https://github.com/me/stack", build="colcon")
    decision = decided(tmp_path, files, config=Config(source=(stack,)))
    assert "arm_controller" in decision.rosdep


def test_a_controller_that_is_called_like_its_package_is_that(tree: Tree) -> None:
    config = "joint_state_broadcaster:\n  type: joint_state_broadcaster/JointStateBroadcaster\n"
    decision = tree({**_files("joint_state_broadcaster"), "config/controllers.yaml": config})
    assert "joint_state_broadcaster" in decision.rosdep
    assert decision.skip_keys == ()


@pytest.mark.parametrize(
    ("key", "apt"),
    [("opencv4", "libopencv-dev"), ("libcrypto", "libssl-dev"), ("boost_serialization", "libboost-all-dev")],
)
def test_names_of_pkg_config_and_of_the_linker_are_libraries(tree: Tree, key: str, apt: str) -> None:
    decision = tree(_files(key))
    assert apt in {*decision.apt, *decision.apt_guessed}
    assert key in decision.skip_keys
    assert [each.message for each in decision.warnings if f"{apt} is installed for it" in each.message]
    assert decision.source == ()


def test_a_package_that_begins_like_a_library_is_none(tree: Tree) -> None:
    assert "boost_of_ours" not in tree(_files("boost_of_ours")).skip_keys


@pytest.mark.parametrize("key", ["python3-pymavlink", "python-pymavlink"])
def test_a_key_is_brought_by_what_pip_installs(tree: Tree, key: str) -> None:
    decision = tree({**_files(key), "README.md": "ROS 2 Jazzy\n```\npip install pymavlink\n```\n"})
    assert key in decision.skip_keys
    assert [each.message for each in decision.warnings if "pip installs pymavlink" in each.message]
    assert not [each.message for each in decision.warnings if "nothing here says" in each.message]


def test_a_key_that_pip_installs_nothing_for_is_unknown(tree: Tree) -> None:
    decision = tree(_files("python3-pymavlink"))
    assert [each.message for each in decision.warnings if "nothing here says" in each.message]


@pytest.mark.parametrize(
    ("page", "key", "apt"),
    [
        ("ROS Noetic\n", "python-rospkg", "python3-rospkg"),
        ("ROS 2 Jazzy\n", "python-rospkg", "python3-rospkg"),
        ("ROS Melodic\n", "python-rospkg", ""),
        ("ROS Noetic\n", "python-of-ours", ""),
    ],
)
def test_a_key_of_python_2_is_that_of_python_3_where_there_is_no_other(
    tree: Tree, page: str, key: str, apt: str
) -> None:
    files = {**_files(key), "README.md": page}
    if "ROS 2" not in page:
        files["package.xml"] = files["package.xml"].replace("ament_cmake", "catkin")
        files["CMakeLists.txt"] = "project(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    decision = tree(files)
    assert (key in decision.skip_keys, apt in decision.apt_guessed) == (bool(apt), bool(apt))
    assert bool([each for each in decision.warnings if f"{apt} is installed for it" in each.message]) is bool(apt)


@pytest.mark.parametrize(
    ("key", "more", "said"),
    [
        ("torch", {"net.py": "import rclpy\nimport torch\n"}, "pip installs torch"),
        ("rosbags", {"net.py": "import rclpy\nimport rosbags\n"}, "pip installs rosbags"),
        ("acme_arm", {"requirements.txt": "acme-arm\n"}, "pip installs acme-arm"),
        ("skimage", {"requirements.txt": "scikit-image\n"}, "pip installs scikit-image"),  # its module
        ("python3-multipart", {"requirements.txt": "python-multipart\n"}, "pip installs python-multipart"),
        ("python3-multipart", {"requirements.txt": "acme-multipart\n"}, "nothing here says where it comes from"),
        ("acme_arm", {"requirements.txt": "acme-leg\n"}, "the build looks for it"),
        (
            "acme_arm",
            {"requirements.txt": "acme-arm\n", "a.cpp": "#include <acme_arm/a.hpp>\n"},
            "the build looks for it",
        ),
    ],
)
def test_what_pip_installs_is_no_unknown_key(tree: Tree, key: str, more: dict[str, str], said: str) -> None:
    decision = tree({**_files(key), **more})
    (found,) = [
        each.message for each in decision.warnings if f"no key {key} " in each.message or f"{key} is no" in each.message
    ]
    assert said in found
    assert (key in decision.skip_keys) == ("pip" in said)
    assert bool(decision.source) == ("looks" in said)
