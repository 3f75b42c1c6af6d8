"""What a page starts that ROS alone runs makes a repository without a package.xml one of ROS."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GUARD = "if __name__ == '__main__':\n    main()\n"
NODE = f"import rclpy\nfrom planner import plan\n{GUARD}"
CODE = {"control/planner.py": "import numpy\nimport scipy\nimport cv2\n", "requirements.txt": "numpy\nscipy\n"}
LAUNCH = "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([])\n"
OLD = '<launch><node pkg="tf" type="static_transform_publisher" name="a"/></launch>\n'


def page(*lines: str) -> str:
    return "# Demo\n\nROS 2 Humble, or ROS Noetic\n\n## Run\n\n```\n" + "\n".join(lines) + "\n```\n"


@pytest.mark.parametrize(
    ("files", "said", "kind", "command"),
    [
        ({**CODE, "control/run.py": NODE}, "python3 control/run.py", "ros2", "python3 control/run.py"),
        (
            {**CODE, "control/run.py": NODE.replace("rclpy", "rospy")},
            "python3 control/run.py",
            "ros1",
            "python3 control/run.py",
        ),
        ({"demo.launch.py": LAUNCH}, "ros2 launch demo.launch.py", "ros2", "ros2 launch demo.launch.py"),
        (
            {"launch/demo.launch.py": LAUNCH, "a.py": "import numpy\n"},
            "ros2 launch launch/demo.launch.py use_sim_time:=true",
            "ros2",
            "ros2 launch launch/demo.launch.py use_sim_time:=true",
        ),
        (
            {"launch/demo.launch": OLD, "a.py": "import numpy\n"},
            "roslaunch launch/demo.launch",
            "ros1",
            "roslaunch launch/demo.launch",
        ),
        (
            {**CODE, "ros/run.py": NODE, "train.py": f"import numpy\n{GUARD}"},
            "python3 train.py",
            "python",
            "python3 train.py",
        ),
        (
            {**CODE, "ros/run.py": NODE, "train.py": f"import numpy\n{GUARD}"},
            "python3 train.py\npython3 ros/run.py",
            "python",
            "python3 train.py",
        ),
        ({**CODE, "control/run.py": f"import torch\n{NODE}"}, "python3 control/run.py", "cuda", None),
        ({"demo.launch.py": LAUNCH, "a.py": f"import numpy\n{GUARD}"}, "python3 a.py", "python", "python3 a.py"),
        ({"demo.launch.py": LAUNCH}, "ros2 launch other demo.launch.py", "python", None),
    ],
)
def test_what_the_page_starts(tree: Tree, files: dict[str, str], said: str, kind: str, command: str | None) -> None:
    found = tree({**files, "README.md": page(said)})
    assert found.kind == kind
    if command:
        assert " ".join(found.command) == command


NODE = "find_package(catkin{} COMPONENTS roscpp tf)\nadd_executable(map_node a.cpp)\n"


@pytest.mark.parametrize(
    ("top", "node", "built"),
    [
        ("project(map)\nadd_subdirectory(ros)\n", NODE.format(" REQUIRED"), ("ros1", "cmake")),
        ("project(map)\n" + NODE.format(" REQUIRED"), "", ("ros1", "cmake")),
        ("project(map)\nadd_subdirectory(ros)\n", NODE.format(""), ("cpp", "cmake")),
        ("project(map)\nif(WITH_ROS)\nadd_subdirectory(ros)\nendif()\n", NODE.format(" REQUIRED"), ("cpp", "cmake")),
    ],
)
def test_cmake_that_always_requires_packages_of_ros(tree: Tree, top: str, node: str, built: tuple[str, str]) -> None:
    page = "# Map\n```\nmkdir build && cd build\ncmake ..\nmake\n```\n"
    files = {"CMakeLists.txt": top, "a.cpp": "int main() {}\n", "README.md": page}
    found = tree({**files, **({"ros/CMakeLists.txt": node} if node else {})})
    assert (found.kind, found.build_tool) == built


ROSCPP = "find_package(roscpp REQUIRED)\nadd_executable(talk a.cpp)\n"
RCLCPP = ROSCPP.replace("roscpp", "rclcpp")


@pytest.mark.parametrize(
    ("files", "built", "command"),
    [
        ({"CMakeLists.txt": f"project(a)\n{ROSCPP}"}, ("ros1", "cmake"), "talk"),
        ({"CMakeLists.txt": f"project(a)\n{RCLCPP}"}, ("ros2", "cmake"), "talk"),
        (
            {"CMakeLists.txt": "project(a)\nadd_subdirectory(n)\n", "n/CMakeLists.txt": RCLCPP},
            ("ros2", "cmake"),
            "talk",
        ),
        ({"CMakeLists.txt": f"project(a)\n{ROSCPP.replace(' REQUIRED', '')}"}, ("cpp", "cmake"), "talk"),
        ({"CMakeLists.txt": f"project(a)\nif(ROS)\n{ROSCPP}endif()\n"}, ("cpp", "cmake"), "talk"),
        (
            {"CMakeLists.txt": "project(a)\nadd_executable(map a.cpp)\n", "n/CMakeLists.txt": f"project(n)\n{ROSCPP}"},
            ("cpp", "cmake"),
            "map",
        ),
        ({"CMakeLists.txt": f"project(a)\n{ROSCPP}".replace("roscpp", "std_msgs")}, ("cpp", "cmake"), "talk"),
    ],
)
def test_cmake_that_finds_what_one_ros_alone_has(
    tree: Tree, files: dict[str, str], built: tuple[str, str], command: str
) -> None:
    found = tree({"a.cpp": "int main() {}\n", "README.md": "# A\n```\ncmake ..\nmake\n```\n", **files})
    assert (found.kind, found.build_tool) == built
    assert " ".join(found.command) == command


MODULE = '[submodule "msgs"]\n\tpath = msgs\n\turl = https://github.com/me/msgs\n'
AMENT = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"


@pytest.mark.parametrize(
    ("changed", "built"),
    [
        ({"msgs/package.xml": AMENT.format("msgs"), ".gitmodules": MODULE}, ("ros1", "cmake")),
        ({"msgs/manifest.xml": "<package/>", ".gitmodules": MODULE}, ("ros1", "cmake")),
        ({"msgs/package.xml": AMENT.format("msgs")}, ("ros2", "colcon")),
        ({"msgs/package.xml": AMENT.format("msgs"), "b/package.xml": AMENT.format("b"), ".gitmodules": MODULE}, None),
    ],
)
def test_the_package_of_a_submodule_is_none_of_the_project(
    tree: Tree, changed: dict[str, str], built: tuple[str, str] | None
) -> None:
    code = {"a.cpp": "int main() {}\n", "msgs/CMakeLists.txt": "project(msgs)\n", "b/CMakeLists.txt": "project(b)\n"}
    found = tree({"CMakeLists.txt": f"project(a)\n{ROSCPP}", **code, **changed})
    assert (found.kind, found.build_tool) == (built or ("ros2", "colcon"))


ON_CUDA = {
    **CODE,
    "setup.py": "from setuptools import setup\nsetup(name='demo', install_requires=['torch'])\n",
    "ros2/run.py": f"import torch\nimport rclpy\n{GUARD}",
}
IMAGE = (
    "FROM nvidia/cuda:12.1.1-cudnn8-devel-ubuntu22.04\nARG ROS_DISTRO=humble\n"
    "RUN apt-get update && apt-get install -y ros-${ROS_DISTRO}-desktop\nCOPY . /app\n"
)


@pytest.mark.parametrize(
    ("changed", "kind", "distro"),
    [
        ({}, "ros2", "humble"),
        ({"ros2/run.py": f"import torch\nimport numpy\n{GUARD}"}, "cuda", None),
        ({"Dockerfile": IMAGE.replace("ros-${ROS_DISTRO}-desktop", "git")}, "cuda", None),
        ({"Dockerfile": IMAGE.replace("humble", "noetic")}, "cuda", None),
    ],
)
def test_the_image_of_the_author_has_ros_beside_cuda(
    tree: Tree, changed: dict[str, str], kind: str, distro: str | None
) -> None:
    decision = tree(ON_CUDA | {"Dockerfile": IMAGE} | changed)
    assert (decision.kind, decision.ros_distro) == (kind, distro)


@pytest.mark.parametrize("title", ["Run:", "Usage", "How to run", "Quick start"])
def test_a_bare_line_below_a_title_about_running_is_the_command(tree: Tree, title: str) -> None:
    page = f"# Demo\nText.\n\n## {title}\npython3 ros2/run.py\n\nClick on it.\n"
    files = {**ON_CUDA, "other.py": f"import numpy\n{GUARD}", "Dockerfile": IMAGE, "README.md": page}
    assert tree(files | {"Dockerfile": IMAGE + "WORKDIR /app\n"}).command == ("python3", "ros2/run.py")
