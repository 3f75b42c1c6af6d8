"""A page names files of the tree by where people clone it to: in the image they lie below the root."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

PACKAGE = "<package><name>vins</name><buildtool_depend>catkin</buildtool_depend></package>"
BUILD = "project(vins)\nfind_package(catkin REQUIRED)\nadd_executable(vins_node a.cpp)\nadd_executable(other b.cpp)\n"
ROS = {"package.xml": PACKAGE, "CMakeLists.txt": BUILD, "config/a.yaml": "a: 1\n", "launch/a.launch": "<launch/>\n"}


def decided(tmp_path: Path, files: dict[str, str]) -> Decision:
    root = tmp_path / "Vins-Demo"
    for path, text in files.items():
        target = root / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    return decide(gather(Repository.open(root)), Config(), folder_name="Vins-Demo")


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("rosrun vins vins_node ~/catkin_ws/src/Vins-Demo/config/a.yaml", "rosrun vins vins_node config/a.yaml"),
        ("rosrun vins vins_node /home/me/ws/src/vins-demo/config/a.yaml", "rosrun vins vins_node config/a.yaml"),
        ("rosrun vins vins_node $HOME/Vins-Demo/config/a.yaml", "rosrun vins vins_node config/a.yaml"),
        ("roslaunch ~/ws/src/Vins-Demo/launch/a.launch", "roslaunch vins a.launch"),
        ("rosrun vins vins_node ~/catkin_ws/src/Vins-Demo/config/b.yaml", "rosrun vins other"),
        ("rosrun vins vins_node ~/catkin_ws/src/Vins/config/a.yaml", "rosrun vins vins_node config/a.yaml"),
        ("rosrun vins vins_node ~/catkin_ws/src/Vins-De/config/a.yaml", "rosrun vins other"),
        ("rosrun vins vins_node ~/catkin_ws/src/another/config/a.yaml", "rosrun vins other"),
        ("roslaunch vins a.launch file:=~/ws/src/Vins-Demo/config/a.yaml", "roslaunch vins a.launch"),
    ],
)
def test_a_file_in_the_readers_checkout_is_the_trees(tmp_path: Path, said: str, command: str) -> None:
    page = f"# Vins\nROS noetic\n\n## Run\n\n```\n{said}\nrosrun vins other\n```\n"
    assert " ".join(decided(tmp_path, {**ROS, "README.md": page}).command) == command


def test_a_container_that_starts_elsewhere_is_given_the_file_from_there(tmp_path: Path) -> None:
    page = "## Run\n\n```\nrosrun vins vins_node config/a.yaml\nrosrun vins other\n```\n"
    dockerfile = 'FROM ros:noetic\nCOPY . /ws/src/demo\nWORKDIR /ws\nRUN catkin_make\nCMD ["bash"]\n'
    found = decided(tmp_path, {**ROS, "README.md": page, "Dockerfile": dockerfile})
    assert (found.dockerfile, found.command) == (
        "Dockerfile",
        ("rosrun", "vins", "vins_node", "src/demo/config/a.yaml"),
    )


MAIN = "if __name__ == '__main__':\n    pass\n"
OPTIONS = f"import argparse\np = argparse.ArgumentParser()\np.add_argument('--device', default='cpu')\n{MAIN}"


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("python3 vins-demo/flow/fly.py --device X", "python3 flow/fly.py"),
        ("python3 Vins-Demo/flow/fly.py --map Vins-Demo/maps/a.yaml", "python3 flow/fly.py --map maps/a.yaml"),
        ("python3 vins-demo/own.py", "python3 vins-demo/own.py"),
        ("python3 another/flow/fly.py", "bash"),
    ],
)
def test_a_page_may_be_read_from_above_the_clone(tmp_path: Path, said: str, command: str) -> None:
    files = {"flow/fly.py": OPTIONS, "flow/land.py": MAIN, "own.py": MAIN, "vins-demo/own.py": MAIN, "maps/a.yaml": ""}
    page = f"# Vins\n\n## Run\n\n```\n{said}\n```\n"
    assert " ".join(decided(tmp_path, {**files, "README.md": page}).command) == command


ROS2 = {
    "package.xml": '<package format="3"><name>vins</name><buildtool_depend>ament_cmake</buildtool_depend></package>',
    "CMakeLists.txt": BUILD.replace("catkin", "ament_cmake") + "install(TARGETS vins_node DESTINATION lib/vins)\n",
    "config/a.yaml": "a: 1\n",
    "launch/a.launch.py": "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
    "def generate_launch_description():\n  return LaunchDescription([Node(package='vins', executable='vins_node')])\n",
}


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("ros2 run vins vins_node --params-file src/Vins-Demo/config/a.yaml", "--params-file config/a.yaml"),
        ("ros2 run vins vins_node --params-file ./src/config/a.yaml", "--params-file config/a.yaml"),
        ("ros2 run vins vins_node --params-file src/other/config/a.yaml", "--params-file src/other/config/a.yaml"),
        ("cd ~/ws\nros2 launch vins a.launch.py file:=./src/vins-demo/config/a.yaml", "file:=config/a.yaml"),
        ("ros2 launch vins a.launch.py file:=~/ws/src/Vins-Demo/config/a.yaml", "file:=config/a.yaml"),
        ("ros2 launch vins a.launch.py file:=src/other/config/a.yaml", "file:=src/other/config/a.yaml"),
        ("ros2 launch vins a.launch.py file:=$(ros2 pkg prefix --share vins)/config/a.yaml", "file:=config/a.yaml"),
        ("ros2 run vins vins_node --params-file `ros2 pkg prefix vins`/share/vins/config/a.yaml", " config/a.yaml"),
        ("ros2 run vins vins_node --ros-args $(ros2 pkg prefix --share vins)/other/a.yaml", "run vins vins_node"),
        ("cd config\nros2 launch vins a.launch.py file:=src/Vins-Demo/config/a.yaml", "src/Vins-Demo/config/a.yaml"),
    ],
)
def test_a_file_is_named_from_the_workspace(tmp_path: Path, said: str, command: str) -> None:
    page = f"# Vins\nROS 2 humble\n\n## Run\n\n```\n{said}\n```\n"
    assert " ".join(decided(tmp_path, {**ROS2, "README.md": page}).command).endswith(command)


def test_a_folder_that_rospack_finds_is_the_trees(tmp_path: Path) -> None:
    for said, command in (
        ("roslaunch $(rospack find vins)/launch/a.launch rate:=5", "roslaunch vins a.launch rate:=5"),
        ("rosrun vins vins_node $(rospack find vins)/config/a.yaml", "rosrun vins vins_node config/a.yaml"),
    ):
        page = f"# Vins\nROS noetic\n\n## Run\n\n```\n{said}\n```\n"
        assert " ".join(decided(tmp_path, {**ROS, "README.md": page}).command) == command


def test_roslaunch_starts_nodes_in_a_folder_of_their_own(tmp_path: Path) -> None:
    page = "# Vins\nROS noetic\n\n## Run\n\n```\nroslaunch vins a.launch file:=src/Vins-Demo/config/a.yaml\n```\n"
    command = " ".join(decided(tmp_path, {**ROS, "README.md": page}).command)
    assert command == "roslaunch vins a.launch file:=src/Vins-Demo/config/a.yaml"


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("bash ~/catkin_ws/src/arm/launch/run.bash", "bash arm/launch/run.bash"),
        ("bash ~/catkin_ws/src/arm/syncTime.sh\nbash ~/catkin_ws/src/arm/launch/run.bash", "bash arm/launch/run.bash"),
        ("rosrun vins vins_node ~/ws/src/arm/a.yaml", "rosrun vins vins_node arm/a.yaml"),
        ("bash ~/catkin_ws/src/hand/launch/run.bash", "rosrun vins other"),
        ("bash ~/catkin_ws/src/run.bash", "rosrun vins other"),
        ("bash ~/catkin_ws/src/twice/run.bash", "rosrun vins other"),
    ],
)
def test_a_package_of_the_tree_lies_by_its_own_name_in_a_workspace(tmp_path: Path, said: str, command: str) -> None:
    run = "#!/bin/bash\nrosrun vins vins_node\n"
    scripts = ("arm/launch/run.bash", "arm/syncTime.sh", "a/twice/run.bash", "b/twice/run.bash")
    files = {**ROS, **dict.fromkeys(scripts, run), "arm/a.yaml": "a: 1\n"}
    page = f"ROS Noetic\n## Run\n```\n{said}\nrosrun vins other\n```\n"
    found = decided(tmp_path, {**files, "README.md": page}).command
    assert (found if isinstance(found, str) else " ".join(found)) == command
