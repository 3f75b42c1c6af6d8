"""The default command is the program that the README runs first, if the tree can start it."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.candidate import Candidate
from roslab.decide.decision import Decision
from roslab.decide.upkeep import upkeep
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>{tool}</buildtool_depend></package>"
ROS1 = {
    "package.xml": PACKAGE.format(tool="catkin"),
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(${PROJECT_NAME}_node a.cpp)\n",
    **{f"scripts/{name}.py": "" for name in ("engine_generation", "onnx_to_trt", "map_generation")},
    **{f"scripts/{name}": "" for name in ("bringup_can2usb.bash", "can_up.sh", "scan_map.sh")},
    "launch/map.launch": "<launch/>",
    "launch/odometry.launch": "<launch/>",
    "launch/replay.launch": "<launch/>",
}
ROS2 = {
    "package.xml": PACKAGE.format(tool="ament_cmake"),
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_executable(talker a.cpp)\n",
    "launch/map.launch.py": "from launch import LaunchDescription\n",
    "launch/bringup.launch.py": "from launch import LaunchDescription\n",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("```\nroslaunch demo map.launch\nroslaunch demo odometry.launch\n```\n", "roslaunch demo map.launch"),
        ("roslaunch demo map.launch\n# Usage\nroslaunch demo odometry.launch\n", "roslaunch demo odometry.launch"),
        (
            "# Calibration\nroslaunch demo map.launch\n# Demo\nroslaunch demo replay.launch\n",
            "roslaunch demo replay.launch",
        ),
        (
            "# Run\n## Tests\nroslaunch demo map.launch\n## Simulation\nroslaunch demo replay.launch\n",
            "roslaunch demo replay.launch",
        ),
        (
            "roslaunch demo gone.launch\nroslaunch demo replay.launch\nroslaunch demo map.launch\n",
            "roslaunch demo replay.launch",
        ),
        ("roslaunch camera_driver usb.launch\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("ros2 launch demo map.launch.py\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("roslaunch demo replay.launch bag:=data/a.bag\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("rosrun demo download_bags.sh\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("rosrun demo bringup_can2usb.bash\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("rosrun demo can_up.sh\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("rosrun demo scan_map.sh\nroslaunch demo map.launch\n", "rosrun demo scan_map.sh"),
        ("rosrun demo engine_generation.py\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("rosrun demo onnx_to_trt.py\nroslaunch demo map.launch\n", "roslaunch demo map.launch"),
        ("rosrun demo map_generation.py\nroslaunch demo map.launch\n", "rosrun demo map_generation.py"),
        ("roslaunch launch/map.launch\n", "roslaunch demo map.launch"),
        ("Start it:\n```\n./devel/lib/demo/demo_node --fast\n```\n", "rosrun demo demo_node --fast"),
        ("roslaunch demo gone.launch\n", "bash"),
        ('1. Run "roslaunch demo replay.launch a:=1", then see.\n', "roslaunch demo replay.launch a:=1"),
        ("Then start roslaunch demo map.launch.\n", "roslaunch demo map.launch"),
        ("Here roslaunch demo map.launching is no command.\n", "bash"),
    ],
)
def test_the_first_command_of_a_page_for_ros_1(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree({**ROS1, "README.md": page}).command) == command


@pytest.mark.parametrize(
    ("script", "page", "command"),
    [
        ("addSubmodules.sh", "README.md", "roslaunch demo map.launch"),
        ("init_submodules.sh", "README.md", "roslaunch demo map.launch"),
        ("add_noise.sh", "README.md", "bash add_noise.sh"),
        ("_boot.sh", "README.md", "roslaunch demo map.launch"),
        ("boot.sh", "README.md", "bash boot.sh"),
        ("boot.sh", "plans/README.md", "roslaunch demo map.launch"),
    ],
)
def test_what_only_those_who_write_the_code_run_comes_last(tree: Tree, script: str, page: str, command: str) -> None:
    pages = {page: f"# Usage\n```\n./{script}\n```\n"}
    pages["README.md"] = pages.get("README.md", "") + "```\nroslaunch demo map.launch\n```\n"
    there = f"{page.rpartition('/')[0]}/{script}".lstrip("/")
    assert " ".join(tree({**ROS1, there: "roslaunch demo map.launch\n", **pages}).command) == command


@pytest.mark.parametrize(
    ("viewer", "command"),
    [("rosrun rviz rviz", "bash"), ("rosrun rviz rviz -d demo.rviz", "rosrun rviz rviz -d demo.rviz")],
)
def test_a_bare_viewer_is_no_command_of_a_tree_without_packages(tree: Tree, viewer: str, command: str) -> None:
    page = f"ROS Noetic\n# Run\ncatkin_make\n{viewer}\n"
    modules = '[submodule "a"]\n\tpath = a\n\turl = https://github.com/lab/a.git\n'
    assert " ".join(tree({"README.md": page, ".gitmodules": modules, "demo.rviz": ""}).command) == command


MAP, NODE, ABSENT = "roslaunch demo map.launch\n", "rosrun demo demo_node\n", "roslaunch camera_driver usb.launch\n"
ODOMETRY = "roslaunch demo odometry.launch\n"


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (f"# Robot\n{MAP}# Run the camera\n{NODE}", MAP),
        (f"# Robot\n{MAP}# Run the camera\nroscore\n{NODE}", NODE),
        (f"# Calibration\n{MAP}# Run the camera\n{NODE}", NODE),
        (f"# Robot\nroslaunch demo map.launch a:=data/a.bag\n# Run the camera\n{NODE}", NODE),
        (f"# Run the camera\n{NODE}# Robot\n{MAP}", NODE),
        (f"# Robot\n{MAP}# Run the camera\n{ABSENT}{ODOMETRY}", MAP),
        (f"# Robot\n{MAP}# Run the camera\n{ODOMETRY}{ABSENT}", ODOMETRY),
        (f"# Calibration\n{MAP}# Run the camera\n{ABSENT}{ODOMETRY}", ODOMETRY),
        (f"# Robot\n{MAP}# Run the camera\nroslaunch usb_cam usb_cam.launch\n{ODOMETRY}", ODOMETRY),
        (f"# Robot\n{MAP}# Get the driver\n{ABSENT}# Run\n{ODOMETRY}", ODOMETRY),
        (
            f"# Robot\n{MAP}# Run\ncd ~/catkin_ws/src\ngit clone https://github.com/lab/x.git\n{ABSENT}{ODOMETRY}",
            ODOMETRY,
        ),
    ],
)
def test_what_needs_others_comes_behind_what_a_page_launches_alone(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree({**ROS1, "README.md": f"ROS Noetic\n{page}"}).command) == command.strip()


@pytest.mark.parametrize(
    ("first", "titles", "command"),
    [
        ("./validate_demo.sh", "Build / Mapping", "bash run_map.sh"),
        ("./verify.sh", "Build / Mapping", "bash run_map.sh"),
        ("./start.sh", "Build / Mapping", "bash start.sh"),
        ("./start.sh", "Build and verify / Start it", "bash run_map.sh"),
        ("./start.sh", "3. 构建并验证 / 4. 启动建图", "bash run_map.sh"),
        ("./start.sh", "运行环境 / 建图", "bash start.sh"),
    ],
)
def test_what_is_checked_after_the_build_is_not_what_is_run(tree: Tree, first: str, titles: str, command: str) -> None:
    title, second = titles.split(" / ")
    page = f"# Demo\n### {title}\n```\n{first}\n```\n### {second}\n```\n./run_map.sh\n```\n"
    scripts = dict.fromkeys((first[2:], "run_map.sh"), "ros2 launch demo map.launch.py\n")
    assert " ".join(tree({**ROS2, **scripts, "README.md": page}).command) == command


@pytest.mark.parametrize(
    ("launched", "first", "reason"),
    [
        ("map_with_rqt_gui drive", 0, "the README runs it, before 1 other"),
        ("rviz drive", 1, "the README runs it, and 1 other"),
        ("keyboard_control joystick_control", 0, "the README runs it, before 1 other"),
        ("keyboard_control joystick_camera", 1, "the README runs it, and 1 other"),
        ("keyboard drive", 1, "the README runs it, and 1 other"),
    ],
)
def test_the_order_of_a_page_decides_between_equals(tree: Tree, launched: str, first: int, reason: str) -> None:
    names = [f"{name}.launch" for name in launched.split()]
    page = "# Usage\n" + "".join(f"* `roslaunch demo {name}`\n" for name in names)
    found = tree({**ROS1, **{f"launch/{name}": "<launch/>" for name in names}, "README.md": page})
    assert found.command == ("roslaunch", "demo", names[first])
    assert reason in [each.reason for each in found.reasons if each.question == "command" and each.decisive]


def test_a_package_may_be_for_what_others_only_do_after_it(tree: Tree) -> None:
    files = {path: text.replace("demo", "arm_calibration") for path, text in ROS1.items() if "launch" not in path}
    page = "# Examples\n```\n./build/arm_calibration_node --fast\n```\n```\n./build/arm_calibration_node\n```\n"
    assert tree({**files, "README.md": page}).command == (
        "rosrun", "arm_calibration", "arm_calibration_node", "--fast",
    )  # fmt: skip
    page = page.replace("arm_calibration_node", "teleop_node")
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("${PROJECT_NAME}_node", "teleop_node")
    files["CMakeLists.txt"] += "add_executable(mapper b.cpp)\n"
    assert tree({**files, "README.md": page}).command == ("rosrun", "arm_calibration", "mapper")


def test_the_root_page_comes_before_those_of_folders(tree: Tree) -> None:
    pages = {"a/README.md": "# Usage\nroslaunch demo map.launch\n", "README.md": "roslaunch demo replay.launch\n"}
    assert tree({**ROS1, **pages}).command == ("roslaunch", "demo", "replay.launch")


def test_the_first_command_of_a_page_for_ros_2(tree: Tree) -> None:
    page = "roslaunch demo map.launch\nros2 run demo talker a:=---\nros2 launch demo map.launch.py\n"
    assert tree({**ROS2, "README.md": page}).command == ("ros2", "launch", "demo", "map.launch.py")


@pytest.mark.parametrize(
    ("link", "more", "command"),
    [
        ("[x](how/b.md) [y](how/a.md#run)", "", "map.launch.py"),
        ("[y](https://github.com/lab/demo/tree/humble/how/a.md) [x](how/b.md)", "", "second.launch.py"),
        ("[y](how/a.md)", "ros2 launch demo map.launch.py\n", "map.launch.py"),
        ("how/b.md, [z](how/contributing.md), [w](how/gone.md), [v](how/tools.md)", "", ""),
    ],
)
def test_where_the_root_page_starts_nothing_a_page_that_it_links_to_may(
    tree: Tree, link: str, more: str, command: str
) -> None:
    named = {"a": "second", "b": "map", "contributing": "second", "tools": "second"}
    pages = {f"how/{page}.md": f"# Start\n```\nros2 launch demo {of}.launch.py\n```\n" for page, of in named.items()}
    files = {path.replace("bringup", "second"): text for path, text in ROS2.items()} | pages
    found = tree({**files, "README.md": f"# Demo\nSee {link}.\n{more}"})
    assert found.command[-1] == (command or "bash")


def test_where_no_page_runs_anything_a_name_may_tell(tree: Tree) -> None:
    assert tree(ROS2).command == ("ros2", "launch", "demo", "bringup.launch.py")


def test_of_many_launch_files_no_name_tells(tree: Tree) -> None:
    more = {f"launch/part_{number}.launch.py": "from launch import LaunchDescription\n" for number in range(8)}
    assert tree({**ROS2, **more}).command == ("bash",)


@pytest.mark.parametrize(
    ("parts", "command"),
    [
        ({"robot.whole": "map drive", "drive": "wheels", "check": ""}, "robot.whole.launch.py"),
        ({"whole": "map", "other": "drive", "drive": ""}, ""),
        ({"whole": "map drive", "other": "map drive", "drive": ""}, ""),
        ({"whole": "gone map", "drive": ""}, ""),
        ({"whole": "map drive", "drive": "", "wheels": "@nowhere_at_all"}, "whole.launch.py"),
        ({"whole": "map drive", "drive": "@nav2_bringup"}, "whole.launch.py"),
        ({"whole": "map drive", "drive": "@nowhere_at_all"}, ""),
    ],
)
def test_where_no_page_runs_anything_the_launch_file_that_brings_most_is_run(
    tree: Tree, parts: dict[str, str], command: str
) -> None:
    parts = {"map": "", "wheels": "", **parts}
    text = "from launch import LaunchDescription\n"
    launch = {
        f"launch/{name}.launch.py": text
        + "".join(
            f"Node(package='{part[1:]}', executable='x')\n" if part[0] == "@" else f"include('{part}.launch.py')\n"
            for part in below.split()
        )
        for name, below in parts.items()
    }
    files = {path: text for path, text in ROS2.items() if not path.startswith("launch/")}
    found = tree({**files, **launch}).command
    assert found == (("ros2", "launch", "demo", command) if command else ("bash",))


CMAKE = "project(Align CXX)\n{more}add_executable(align a.cpp)\nadd_executable(convert b.cpp)\nadd_subdirectory(apps)\n"
APPS = {"apps/CMakeLists.txt": "add_executable(viewer v.cpp)\n", "a.cpp": "int main() {}\n", "maps/a.yaml": "a: 1\n"}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("# Run\n```\ncd build\n./align -i ../maps/a.yaml\n```\n", "align -i maps/a.yaml"),
        ("```\n./convert maps/a.yaml\n./build/apps/viewer\n```\n", "viewer"),
        ("```\n./align /data/kitti/00\n./apps/viewer\n```\n", "viewer"),
        ("Then run `viewer` in the folder.\n```\nmkdir build\n```\n", "viewer"),
        ("```\n./align data/kitti.bag\n```\n", "align data/kitti.bag"),
        ("```\n./align -i=../data/a.bag -p\n```\nSee all with `./align -help`.\n", "align -i=data/a.bag -p"),
        ("```\ncd build\n./align ../../kitti/00 --out=../results\n```\n", "align kitti/00 --out=results"),
        ("```\n./build/align ../kitti/00\n```\n", "align ../kitti/00"),
        ("```\n./align --version\n./align -n 3\n```\n", "align -n 3"),
        ("```\n./align --self-test\n./align -n 3\n```\n", "align -n 3"),
        ("```\n./install.sh\n```\n", "bash"),
    ],
)
def test_the_first_compiled_program_of_a_page(tree: Tree, page: str, command: str) -> None:
    files = {**APPS, "CMakeLists.txt": CMAKE.format(more=""), "README.md": page}
    assert " ".join(tree(files).command) == command


@pytest.mark.parametrize(
    ("page", "settings", "command"),
    [
        ("./align ../maps/a.yaml ../a.cpp", "code: ../a.cpp\n", "cd maps && exec align a.yaml ../a.cpp"),
        ("./align ../maps/a.yaml", "folder=../apps/\n", "cd maps && exec align a.yaml"),
        ("./align ../maps/a.yaml", "code: ../elsewhere.cpp\n", ""),
        ("./align ../maps/a.yaml ../data/b.bag", "code: ../a.cpp\n", ""),
        ("./align ../maps/a.yaml --out=../a.txt", "code: ../a.cpp\n", ""),
        ("./align maps/a.yaml", "code: ../a.cpp\n", ""),
        ("./align ../maps/a.yaml", "code: a/../../a.cpp\n", ""),
    ],
)
def test_a_program_whose_settings_name_what_is_above_its_build_folder_starts_right_below_the_root(
    tree: Tree, page: str, settings: str, command: str
) -> None:
    files = {**APPS, "CMakeLists.txt": CMAKE.format(more=""), "maps/a.yaml": settings}
    argv = tree({**files, "README.md": f"```\ncd build\n{page}\n```\n"}).command
    found = argv if isinstance(argv, str) else " ".join(argv)
    assert found == command if command else found.startswith("align maps/a.yaml")


def test_a_project_whose_code_is_elsewhere_is_not_the_one_that_is_built(tree: Tree) -> None:
    files = {
        "align/CMakeLists.txt": "project(Align CXX)\nadd_executable(align align_main.cc ${MORE})\n",
        "fuse/depth/CMakeLists.txt": "project(Fuse CXX)\nadd_executable(fuse fuse_main.cc)\n",
        "fuse/depth/fuse_main.cc": "int main() {}\n",
    }
    assert tree(files).command == ("fuse",)
    assert tree({**files, "align/align_main.cc": "int main() {}\n"}).command == ("align",)


@pytest.mark.parametrize(
    ("more", "folders"),
    [
        ("", ("build", "build/apps")),
        ("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_SOURCE_DIR}/bin)\n", ("source/bin",)),
        (
            "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_SOURCE_DIR}/bin/${CMAKE_HOST_SYSTEM_PROCESSOR})\n",
            ("source/bin/x86_64", "source/bin/aarch64"),
        ),
        ("set(EXECUTABLE_OUTPUT_PATH ${PROJECT_SOURCE_DIR}/${CMAKE_SYSTEM_NAME})\n", ("source/Linux",)),
        ("set(EXECUTABLE_OUTPUT_PATH ${PROJECT_BINARY_DIR}/bin)\n", ("build/bin",)),
        ("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${SOMEWHERE}/bin)\n", ("build", "build/apps")),
        ("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ../../bin)\n", ("build", "build/apps")),
    ],
)
def test_the_folders_of_compiled_programs(tree: Tree, more: str, folders: tuple[str, ...]) -> None:
    assert tree({**APPS, "CMakeLists.txt": CMAKE.format(more=more)}).program_folders == folders


@pytest.mark.parametrize(
    ("lines", "folders"),
    [
        (("set(EXECUTABLE_OUTPUT_PATH bin)", "RUN", "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY tools)", "TOOL"), "bin tools"),
        (("RUN", "set(EXECUTABLE_OUTPUT_PATH bin)", "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY tools)", "TOOL"), "bin tools"),
        (("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY a)", "RUN", "set(CMAKE_RUNTIME_OUTPUT_DIRECTORY b)", "TOOL"), "a b"),
        (("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY a)", "RUN", "TOOL"), "a"),
        (("set(EXECUTABLE_OUTPUT_PATH bin)", "RUN", "TOOL", "set(EXECUTABLE_OUTPUT_PATH apps)"), "apps"),
    ],
)
def test_a_program_lies_where_it_is_added(tree: Tree, lines: tuple[str, ...], folders: str) -> None:
    made = "project(x CXX)\n" + "\n".join(lines).replace("RUN\n", "add_executable(run a.cpp)\n")
    made = re.sub(r"(DIRECTORY|PATH) (\w+)", r"\1 ${PROJECT_SOURCE_DIR}/\2", made)
    made = made.replace("TOOL", "add_executable(tool a.cpp)") + "\n"
    decision = tree({"CMakeLists.txt": made, "a.cpp": "int main() {}\n"})
    assert decision.program_folders == tuple(f"source/{folder}" for folder in folders.split())


@pytest.mark.parametrize(
    ("file", "text", "page", "command"),
    [
        ("", "option(DEMO 'a demo' OFF)\nif(DEMO)\n{}endif()\n", "", "bash"),
        ("", "option(DEMO 'a demo' OFF)\nif(DEMO)\n{}endif()\n", "cmake -DDEMO=ON ..", "show"),
        ("", "option(DEMO 'a demo' ON)\nif(DEMO)\n{}endif()\n", "", "show"),
        ("examples/", "if(WITH_MAPS)\n{}endif()\n", "", "bash"),
        ("examples/", "if(WITH_MAPS)\n{}endif()\n", "cmake -DWITH_MAPS=ON ..", "show"),
        ("examples/", "if(UNIX)\n{}endif()\n", "", "show"),
        ("apps/", "if(WITH_MAPS)\n{}endif()\n", "", "show"),
    ],
)
def test_a_program_that_an_option_leaves_out_is_not_the_obvious_one(
    tree: Tree, file: str, text: str, page: str, command: str
) -> None:
    made = text.replace("'", '"').format("add_executable(show show.cpp)\n")
    files = {"CMakeLists.txt": "project(x CXX)\nadd_library(x x.cpp)\nadd_subdirectory(examples)\n", "x.cpp": ""}
    files[f"{file}CMakeLists.txt"] = (files["CMakeLists.txt"] if not file else "") + made
    readme = {"README.md": f"```\ncd build\n{page}\n```\n" if page else "A library.\n"}
    assert tree({**files, **readme, f"{file}show.cpp": "int main() {}\n"}).command == (command,)


def test_a_program_has_the_name_of_its_file(tree: Tree) -> None:
    files = {
        "CMakeLists.txt": "project(x CXX)\nadd_executable(a a.cpp)\n"
        "set_target_properties(a PROPERTIES OUTPUT_NAME align)\n"
    }
    assert tree({**files, "a.cpp": "int main() {}\n"}).command == ("align",)


@pytest.mark.parametrize(
    ("cmake", "code", "gui"),
    [
        ("find_package(Pangolin REQUIRED)\n", "", True),
        ("find_package(Pangolin QUIET)\n", "", False),
        ("find_package(OpenCV REQUIRED)\n", "", False),
        ("", "#include <GLFW/glfw3.h>\n", True),
        ("", "#include <pcl/visualization/pcl_visualizer.h>\n", True),
        ("", "#include <pcl/point_types.h>\n", False),
    ],
)
def test_libraries_that_open_windows(tree: Tree, cmake: str, code: str, gui: bool) -> None:
    files = {"CMakeLists.txt": f"project(x CXX)\n{cmake}add_executable(a a.cpp)\n", "a.cpp": f"{code}int main() {{}}\n"}
    assert tree(files).gui is gui


@pytest.mark.parametrize(("name", "gui"), [("scan_gui", True), ("viewer", True), ("guide", False), ("reviewer", False)])
def test_a_program_that_is_called_a_window_opens_one(tree: Tree, name: str, *, gui: bool) -> None:
    made = f"cmake_minimum_required(VERSION 3.5)\nproject(x CXX)\nadd_executable({name} a.cpp)\n"
    decision = tree({"CMakeLists.txt": made, "a.cpp": "int main() {}\n"})
    assert (decision.command, decision.gui) == ((name,), gui)


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("roslaunch demo map.launch map:=/path/to/your/map.pcd\n", "roslaunch demo map.launch"),
        ("```\nrosrun demo demo_node path/to/config.yaml path/to/bag\n```\n", "rosrun demo demo_node"),
        ("rosrun demo demo_node <config file> 3\n", "rosrun demo demo_node"),
        ("rosrun demo demo_node <config file> 3\nrosrun demo demo_node 4\n", "rosrun demo demo_node 4"),
        ("roslaunch PATH_TO_PACKAGE map.launch\n", "bash"),
        (
            "roslaunch demo map.launch [rviz:=true] [--wait]\nroslaunch demo replay.launch\n",
            "roslaunch demo map.launch",
        ),
        ("rosrun demo demo_node --size <small | large> 3\n", "rosrun demo demo_node 3"),
        ("rosrun demo demo_node -p a:=1 -p map:=<your map>\n", "rosrun demo demo_node -p a:=1"),
        ("roslaunch demo map.launch dir:=/where/to/store/it\n", "roslaunch demo map.launch"),
        ("roslaunch demo map.launch a:=ROBOT_NAME b:=MAP\n", "roslaunch demo map.launch b:=MAP"),
        (
            "roslaunch demo map.launch a:=<A>\nrosrun demo demo_node a:=1\nroslaunch demo map.launch a:=1 b:=2\n",
            "roslaunch demo map.launch a:=1 b:=2",
        ),
        ("roslaunch demo map.launch a:=<A>\nroslaunch demo map.launch b:=2\n", "roslaunch demo map.launch"),
        ("```\n./start_all.sh\n```\n", "bash start_all.sh"),
        ("```\n./config_gcc.sh\npython keyboard.py\n./start_all.sh\n```\n", "bash start_all.sh"),
    ],
)
def test_what_the_reader_fills_in_is_left_out(tree: Tree, page: str, command: str) -> None:
    files = dict.fromkeys(("start_all.sh", "config_gcc.sh", "keyboard.py"), "echo\n")
    assert " ".join(tree({**ROS1, **files, "README.md": page}).command) == command


@pytest.mark.parametrize(
    ("value", "command"),
    [
        ("/maps/hall.yaml", "roslaunch demo map.launch map:=/maps/hall.yaml"),
        ("/other/hall.yaml", "roslaunch demo replay.launch"),
        ("/hall.yaml", "roslaunch demo replay.launch"),
    ],
)
def test_a_path_below_the_package_that_a_launch_file_is_given(tree: Tree, value: str, command: str) -> None:
    page = f"roslaunch demo map.launch map:={value}\nroslaunch demo replay.launch\n"
    assert " ".join(tree({**ROS1, "maps/hall.yaml": "a: 1\n", "README.md": page}).command) == command


@pytest.mark.parametrize(
    ("folder", "command"),
    [
        ("~/catkin_ws/src/Paper/demo/scripts", "cd demo/scripts && exec bash spawn.sh"),
        ("~/catkin_ws/src/Paper", "rosrun demo demo_node"),
        ("~/other/demo/scripts", "rosrun demo demo_node"),
    ],
)
def test_a_script_below_a_folder_of_the_workspace(tree: Tree, folder: str, command: str) -> None:
    page = f"```\ncd {folder}\n./spawn.sh\n```\n```\nrosrun demo demo_node\n```\n"
    found = tree({**ROS1, "demo/scripts/spawn.sh": "roslaunch demo map.launch\n", "README.md": page}).command
    assert (found if isinstance(found, str) else " ".join(found)) == command


@pytest.mark.parametrize(
    ("package", "command"),
    [("cloud_conversion", "rosrun cloud_conversion conversion.py"), ("cloud", "roslaunch cloud map.launch")],
)
def test_a_node_with_the_service_of_its_package_is_meant(tree: Tree, package: str, command: str) -> None:
    files = {path: text.replace("demo", package) for path, text in ROS1.items()}
    page = f"You can test it by:\n> $ rosrun {package} conversion.py\n\nThen: `roslaunch {package} map.launch`\n"
    found = tree({**files, "conversion.py": "import rospy\n", "README.md": page})
    assert " ".join(found.command) == command


def test_options_of_python_go_with_the_value_that_the_reader_fills_in(tree: Tree) -> None:
    page = "# Train\n```\npython train.py --net small --data <Path To Dataset> --fast\n```\n"
    assert tree({"train.py": "import numpy\n", "README.md": page}).command == (
        "python", "train.py", "--net", "small", "--fast",
    )  # fmt: skip


def test_a_page_means_the_program_beside_it(tree: Tree) -> None:
    files = dict.fromkeys(("tasks/a/train.py", "tasks/b/train.py"), "if __name__ == '__main__':\n    pass\n")
    page = {"tasks/b/README.md": "```\n./train.py -d /path/to/data\n```\n"}
    assert tree({**files, **page, "requirements.txt": "numpy\n"}).command == ("python", "tasks/b/train.py")


def test_a_page_below_the_root_runs_a_script_without_a_guard_that_lies_beside_it(tree: Tree) -> None:
    files = dict.fromkeys(("python/show.py", "python/other.py", "matlab/show.py"), "import numpy\n")
    page = {"python/README.md": "```\npython show.py /path/to/data\n```\n", "README.md": "Our data.\n"}
    assert tree({**files, **page, "requirements.txt": "numpy\n"}).command == ("python", "python/show.py")


NOTEBOOK = '{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 4}'


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("```\njupyter notebook demo.ipynb\n```\n", "jupyter notebook --ip=0.0.0.0 --no-browser demo.ipynb"),
        ("Run `jupyter lab nb/more.ipynb` then.\n", "jupyter notebook --ip=0.0.0.0 --no-browser nb/more.ipynb"),
        ("```\njupyter lab $HOME/x/nb/more.ipynb\n```\n", "jupyter notebook --ip=0.0.0.0 --no-browser nb/more.ipynb"),
        ("```\njupyter notebook demo.ipynb\npython train.py --fast\n```\n", "python train.py --fast"),
        ("```\njupyter notebook\n```\n", "bash"),
        ("```\njupyter notebook gone.ipynb\n```\n", "bash"),
    ],
)
def test_a_notebook_that_the_page_opens_is_served(tree: Tree, page: str, command: str) -> None:
    files = {
        "demo.ipynb": NOTEBOOK,
        "nb/more.ipynb": NOTEBOOK,
        "train.py": "import numpy\n",
        "requirements.txt": "numpy\n",
    }
    decision = tree({**files, "README.md": f"# Run\n{page}"})
    assert " ".join(decision.command) == command
    assert any(each.key == "notebook" for each in decision.python.pip_guessed) == (
        ".ipynb" in page and "gone" not in page
    )


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("# Running\nThe demo is at `nb/more.ipynb`, as is demo.ipynb.\n", "nb/more.ipynb"),
        ("# About\nSee [the notebook](demo.ipynb).\n", "demo.ipynb"),
        ("# About\nSee nb/more.ipynb and demo.ipynb.\n", ""),
        ("# Running\nSee demo.ipynb.\n```\npython train.py\n```\n", ""),
    ],
)
def test_a_notebook_that_a_page_names_is_served_where_no_page_runs_anything(
    tree: Tree, page: str, command: str
) -> None:
    files = {"demo.ipynb": NOTEBOOK, "nb/more.ipynb": NOTEBOOK, "requirements.txt": "numpy\n"}
    decision = tree({**files, "train.py": "import numpy\n", "README.md": page})
    served = decision.command == ("jupyter", "notebook", "--ip=0.0.0.0", "--no-browser", command)
    assert served == bool(command)
    assert any(each.key == "notebook" for each in decision.python.pip_guessed) == served


@pytest.mark.parametrize(
    ("page", "opened"),
    [
        ("# Run\nLook at `nb/more.ipynb`:\n```\njupyter notebook\n```\n", "nb/more.ipynb"),
        ("# Run\nDo `jupyter lab`, and open `more.ipynb`.\n", "nb/more.ipynb"),
        ("# Run\nSee demo.ipynb.\n\nSee more.ipynb.\n```\njupyter notebook --port 8000\n```\n", "nb/more.ipynb"),
        ("# Data\nSee demo.ipynb and more.ipynb.\n# Run\n```\njupyter notebook\n```\n", ""),
        ("# About\nThe server is jupyter notebook, for demo.ipynb and more.ipynb.\n", ""),
    ],
)
def test_a_server_of_notebooks_opens_the_one_that_its_section_names(tree: Tree, page: str, opened: str) -> None:
    decision = tree(
        {"demo.ipynb": NOTEBOOK, "nb/more.ipynb": NOTEBOOK, "train.py": "import numpy\n", "README.md": page}
    )
    served = ("jupyter", "notebook", "--ip=0.0.0.0", "--no-browser", opened)
    assert (decision.command == served) == bool(opened)
    assert any(each.key == "notebook" for each in decision.python.pip_guessed) == bool(opened)


def test_a_named_notebook_is_beside_the_program_that_the_page_runs(tree: Tree) -> None:
    page = "# Run\nSee demo.ipynb.\n```\njupyter notebook\n```\n# Drive\n```\npython train.py\n```\n"
    files = {"demo.ipynb": NOTEBOOK, "train.py": "import numpy\n", "README.md": page}
    decision = tree(files)
    assert decision.command == ("python", "train.py")
    assert ("jupyter", "notebook", "--ip=0.0.0.0", "--no-browser", "demo.ipynb") in decision.command_candidates
    assert any(each.key == "notebook" for each in decision.python.pip_guessed)


IN_JULIA = '{"cells": [], "metadata": {"kernelspec": {"language": "julia"}}, "nbformat": 4, "nbformat_minor": 4}'


@pytest.mark.parametrize(
    ("files", "opened"),
    [
        ({"demo.ipynb": NOTEBOOK}, ("demo.ipynb",)),
        ({"1.ipynb": NOTEBOOK, "2.ipynb": NOTEBOOK, "lib/filters.py": "import numpy\n"}, ()),
        ({"demo.ipynb": NOTEBOOK, "lib/run.py": "if __name__ == '__main__':\n    main()\n"}, None),
        ({"demo.ipynb": NOTEBOOK, "setup.py": "from setuptools import setup\nsetup(name='demo')\n"}, None),
        ({"demo.ipynb": IN_JULIA, "lib/filters.py": "import numpy\n"}, None),
    ],
)
def test_a_tree_of_notebooks_is_served(tree: Tree, files: dict[str, str], opened: tuple[str, ...] | None) -> None:
    decision = tree({**files, "README.md": "# Course\n"})
    served = decision.command[:2] == ("jupyter", "notebook")
    assert served == (opened is not None)
    assert decision.command[4:] == (opened or ())
    assert any(each.key == "notebook" for each in decision.python.pip_guessed) == served


def test_the_port_of_a_notebook_is_open_to_this_machine(tmp_path: Path) -> None:
    (tmp_path / "demo.ipynb").write_text(NOTEBOOK, encoding="utf-8")
    (tmp_path / "requirements.txt").write_text("numpy\n", encoding="utf-8")
    (tmp_path / "README.md").write_text("```\njupyter notebook demo.ipynb\n```\n", encoding="utf-8")
    assert plan_repository(tmp_path).plan.run.ports == ("8888",)


def test_a_launch_file_beside_the_page_that_starts_it_keeps_its_name(tree: Tree) -> None:
    page = {"launch/README.md": "```\nros2 launch demo map.launch.py\n```\n"}
    assert tree({**ROS2, **page}).command == ("ros2", "launch", "demo", "map.launch.py")


def test_the_program_of_a_package_without_launch_files_is_run(tree: Tree) -> None:
    files = {name: text for name, text in ROS2.items() if not name.startswith("launch")}
    assert tree(files).command == ("ros2", "run", "demo", "talker")


def test_a_compiled_program_may_be_named_after_its_data(tree: Tree) -> None:
    cmake = (
        "cmake_minimum_required(VERSION 3.5)\nproject(a)\nadd_executable(a_dataset a.cpp)\nadd_executable(b b.cpp)\n"
    )
    page = "Run it:\n\n    bin/a_dataset files=XXX/cam0\n"
    assert tree({"CMakeLists.txt": cmake, "README.md": page}).command == ("a_dataset",)


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("python train.py -s <path to data>\npython render.py -r 2\n", "python train.py"),
        ("python train.py -s <path to data>\npython train.py --demo\n", "python train.py --demo"),
        ("python -W ignore train.py a.yaml\npython render.py\n", "python -W ignore train.py a.yaml"),
        ("python compute_metrics.py\npython visualize_runs.py -n 1\npython train.py -s <data>\n", "python train.py"),
        ("python precache.py -n 1\npython visualize_runs.py -n 1\n", "python visualize_runs.py -n 1"),
    ],
)
def test_the_first_program_of_python_counts_even_with_blanks(tree: Tree, page: str, command: str) -> None:
    names = ("train.py", "render.py", "precache.py", "visualize_runs.py", "compute_metrics.py")
    files = dict.fromkeys(names, "import numpy\n")
    assert " ".join(tree({**files, "README.md": f"```\n{page}```\n"}).command) == command


@pytest.mark.parametrize(
    ("sections", "command"),
    [
        (("Play", "play.py --task=xxx", "Example: running one", "deploy/drive.py a.yaml"), "deploy/drive.py a.yaml"),
        (("Play", "play.py --task=xxx\npython show.py -n 1", "Results", "drive.py"), "play.py"),
        (("Running it", "eval_agent.py --show", "Training", "train.py --log_dir [DIR]"), "eval_agent.py --show"),
        (("Training", "train.py --log_dir [DIR]", "Running it", "eval_agent.py --show"), "train.py"),
        (("Running it", "eval_agent.py --show", "Training", "train.py -n 1"), "train.py -n 1"),
        (("Run", "drive.py {config_name}", "More", "play.py"), "drive.py"),
    ],
)
def test_what_a_section_of_its_own_runs_whole_comes_before_what_has_blanks(
    tree: Tree, sections: tuple[str, ...], command: str
) -> None:
    page = "".join(f"## {a}\n```\npython {b}\n```\n" for a, b in zip(sections[::2], sections[1::2], strict=True))
    names = ("play.py", "show.py", "train.py", "eval_agent.py", "drive.py", "deploy/drive.py")
    files = {name: "import numpy\n" for name in names if f"python {name}" in page}
    assert " ".join(tree({**files, "README.md": page}).command) == f"python {command}"


@pytest.mark.parametrize("model", ["Model", "Test"])
@pytest.mark.parametrize(
    "title",
    [
        "Data Setup",
        "Prepare the datasets",
        "Dataset preparation",
        "Preprocessing",
        "Generate the offline dataset",
        "Transform data into our format",
        "2. Dataset",
    ],
)
def test_a_section_that_makes_the_data_comes_after_what_uses_it(tree: Tree, title: str, model: str) -> None:
    page = f"## {title}\n### Particles\n```\npython particles.py\n```\n## {model}\n```\npython train.py\n```\n"
    files = {"particles.py": "import numpy\n", "train.py": "import numpy\n", "README.md": page}
    assert tree(files).command == ("python", "train.py")
    alone = page.partition(f"## {model}")[0]
    assert tree({**files, "README.md": alone}).command == ("python", "particles.py")


@pytest.mark.parametrize(
    ("line", "command"),
    [
        ("python train.py -h 480 -w 640", "python train.py -h 480 -w 640"),
        ("python train.py -h\npython drive.py", "python drive.py"),
        ("python train.py --help --all\npython drive.py", "python drive.py"),
    ],
)
def test_an_option_with_a_value_asks_for_no_help(tree: Tree, line: str, command: str) -> None:
    files = {"train.py": "import numpy\n", "drive.py": "import numpy\n", "README.md": f"```\n{line}\n```\n"}
    assert " ".join(tree(files).command) == command


def test_a_node_is_not_started_in_an_image_without_ros(tree: Tree) -> None:
    node = "import rospy\nif __name__ == '__main__':\n    rospy.init_node('a')\n"
    page = "# Deployment\n```\npython navigate.py\n```\n# Training\n```\npython train.py\n```\n"
    files = {"navigate.py": node, "train.py": "import torch\n", "requirements.txt": "torch\n", "README.md": page}
    assert tree(files).command == ("python", "train.py")


@pytest.mark.parametrize("other", ["README.Chinese.md", "README-CN.md", "README_fr.md", "Readme.ja.md"])
def test_a_page_in_another_language_comes_after_the_page(tree: Tree, other: str) -> None:
    files = {"train.py": "import numpy\n", "drive.py": "import numpy\n", "README.md": "```\npython train.py\n```\n"}
    assert tree({**files, other: "```\npython drive.py\n```\n"}).command == ("python", "train.py")


def test_a_blank_beside_a_launch_file_does_not_put_off_its_section(tree: Tree) -> None:
    first = "# Run it\n```\nroslaunch demo map.launch\nrosrun demo demo_node <config file>\n```\n"
    page = f"{first}# Run more\n```\nroslaunch demo replay.launch\n```\n"
    assert tree({**ROS1, "README.md": page}).command == ("roslaunch", "demo", "map.launch")


def test_a_program_that_pip_installs_counts_even_with_blanks(tree: Tree) -> None:
    page = "# Usage\n```\nsegment --show <weights> <data>\n```\n# Training\n```\npython scripts/train.py -n 1\n```\n"
    own = "[project]\nname = 'seg'\nversion = '1'\ndependencies = ['numpy']\n[project.scripts]\nsegment = 'seg:main'\n"
    files = {"pyproject.toml": own, "seg/__init__.py": "", "scripts/train.py": "import numpy\n", "README.md": page}
    assert tree(files).command == ("segment",)


@pytest.mark.parametrize(
    ("program", "command"),
    [
        ("install/demo/bin/talker -n 1", "talker -n 1"),
        ("install/demo/lib/demo/talker", "ros2 run demo talker"),
    ],
)
def test_a_program_of_a_workspace_by_its_path(tree: Tree, program: str, command: str) -> None:
    assert " ".join(tree({**ROS2, "README.md": f"# Run\n```\n./{program}\n```\n"}).command) == command


@pytest.mark.parametrize(
    "script",
    [
        "build_tools/changelog.py",
        "cmake/create_module.py",
        "ci/run.py",
        "docs/conf.py",
        "release.py",
        "tools/bump_version.py",
        ".github/stats.py",
    ],
)
def test_what_keeps_the_project_itself_is_no_command(tree: Tree, script: str) -> None:
    guard = "if __name__ == '__main__':\n    print('x')\n"
    files = {"setup.py": "from setuptools import setup\nsetup(name='demo')\n", "demo.pyx": "", script: guard}
    assert tree(files).command == ("bash",)
    assert tree(files | {"README.md": f"```\npython {script}\n```\n"}).command == ("bash",)


@pytest.mark.parametrize(
    ("script", "copies"),
    [("sync_to_nodes.sh", True), ("tools/deploy_to_robot.bash", True), ("clock_sync_to_gps.sh", False)],
)
def test_what_copies_it_to_other_machines_is_no_command(script: str, copies: bool) -> None:
    argv = ("bash", f"scripts/{script}")
    assert upkeep(Candidate(argv=argv, why="", file="README.md", line=1, strong=True)) is copies


@pytest.mark.parametrize(
    ("script", "cleans"),
    [("distclean.sh", True), ("clean_up.bash", True), ("uninstall.sh", True), ("clean_room.sh", False)],
)
def test_what_takes_away_what_was_built_is_no_command(script: str, *, cleans: bool) -> None:
    argv = ("bash", f"lib/{script}")
    assert upkeep(Candidate(argv=argv, why="", file="lib/INSTALL.txt", line=1, strong=True)) is cleans


def test_a_program_that_only_sounds_like_it_is_one(tree: Tree) -> None:
    page = {
        "README.md": "```\npython deploy.py\n```\n",
        "deploy.py": "import numpy\nprint('drives')\n",
        "requirements.txt": "numpy\n",
    }
    assert tree(page).command == ("python", "deploy.py")


def test_a_value_that_only_says_what_it_is_has_to_be_filled_in(tree: Tree) -> None:
    page = "```\npython play.py --algo algo_name --env env_id\npython play.py --algo a2c --env Pong-v4\n```\n"
    files = {"README.md": page, "play.py": "print('plays')\n", "requirements.txt": "numpy\n"}
    assert tree(files).command == ("python", "play.py", "--algo", "a2c", "--env", "Pong-v4")


def test_a_sentence_with_three_backquotes_runs_a_program(tree: Tree) -> None:
    files = {
        "README.md": "- Run ```main.py``` to train the model\n",
        "main.py": "print('trains')\n",
        "requirements.txt": "numpy\n",
    }
    assert tree(files).command == ("python", "main.py")


def test_a_program_below_the_folder_that_the_page_went_to(tree: Tree) -> None:
    page = "```\ncd scripts\nbash build.sh\n```\nTraining\n```\ncd utils\npython train.py --data <folder>\n```\n"
    files = {
        "README.md": page,
        "utils/train.py": "print('trains')\n",
        "scripts/build.sh": "make\n",
        "setup.py": "from setuptools import setup\nsetup()\n",
    }
    assert tree(files).command == ("python", "utils/train.py")


def test_a_learning_environment_is_what_is_run_and_a_file_of_variables_is_not(tree: Tree) -> None:
    page = "# Demos\n```\nbash env.sh\npython demo_reach_env.py --render\npython demo_path.py\n```\n"
    code = {"demo_reach_env.py": "import numpy\n", "demo_path.py": "import numpy\n", "env.sh": "export A=1\n"}
    assert tree({**code, "README.md": page}).command == ("python", "demo_reach_env.py", "--render")


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("# How to run\n## Scenarios\nros2 launch demo scenario_test.launch.py\n", "scenario_test.launch.py"),
        ("# Testing\nros2 launch demo scenario_test.launch.py\n", ""),
        ("# Run\nros2 launch demo scenario_test.launch.py\nros2 launch demo map.launch.py\n", "map.launch.py"),
    ],
)
def test_what_is_named_like_a_test_is_run_where_a_section_about_running_has_nothing_else(
    tree: Tree, page: str, command: str
) -> None:
    launch = {f"launch/{name}.launch.py": "from launch import LaunchDescription\n" for name in ("scenario_test", "b")}
    files = {**ROS2, "launch/bringup.launch.py": "pass\n", **launch, "README.md": page}
    found = tree(files).command
    assert (found[-1] if command else found[0]) == (command or "bash")


@pytest.mark.parametrize("title", ["Train and Test", "Training & Evaluation", "2. Training/testing"])
def test_a_section_that_trains_and_tests_is_about_what_the_code_does(tree: Tree, title: str) -> None:
    page = f"## {title}\n```\npython train.py a.py\n```\n## With half precision\n```\npython half.py a.py\n```\n"
    code = dict.fromkeys(("train.py", "half.py", "a.py"), "import numpy\n")
    assert tree({**code, "README.md": page}).command == ("python", "train.py", "a.py")


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        (["python compute_results.py a.csv", "bash train_and_eval.sh x"], ("bash", "train_and_eval.sh", "x")),
        (["python analyze_log.py a.csv", "python main.py"], ("python", "main.py")),
        (["python train_eval.py", "python main.py"], ("python", "train_eval.py")),
        (["python eval.py", "python main.py"], ("python", "main.py")),
        (["python compute_results.py a.csv"], ("python", "compute_results.py", "a.csv")),
        (["python analyzer.py", "python main.py"], ("python", "analyzer.py")),
    ],
)
def test_what_counts_results_comes_after_what_makes_them(
    tree: Tree, lines: list[str], command: tuple[str, ...]
) -> None:
    page = "# Usage\n" + "".join(f"```\n{line}\n```\n" for line in lines)
    files = {line.split()[1]: "import numpy\n" for line in lines if line.startswith("python")}
    files |= {line.split()[1]: "python main.py\n" for line in lines if line.startswith("bash")}
    assert tree({**files, "a.csv": "1\n", "README.md": page}).command == command


@pytest.mark.parametrize(
    ("script", "command"),
    [
        ("cd /home/me/demo || exit\npython main.py\n", ("python", "app.py")),
        ("set -e\ncd /Users/me/demo\npython main.py\n", ("python", "app.py")),
        ("cd /home/me/demo\npython main.py\n", ("bash", "launch/go.sh")),  # it goes on where it is
        ("python main.py\n", ("bash", "launch/go.sh")),
        ("cd .. || exit\npython main.py\n", "cd launch && exec bash go.sh"),
        ("cd ../ && python main.py\n", "cd launch && exec bash go.sh"),
        ("cd ../.. || exit\npython main.py\n", ("bash", "launch/go.sh")),
        ("cd ..\npython gone.py\n", ("bash", "launch/go.sh")),
    ],
)
def test_a_script_that_goes_to_another_folder(tree: Tree, script: str, command: tuple[str, ...] | str) -> None:
    page = "# Usage\n```\nbash launch/go.sh\n```\n```\npython app.py\n```\n"
    code = dict.fromkeys(("main.py", "app.py"), "import numpy\n")
    assert tree({**code, "launch/go.sh": script, "README.md": page}).command == command


def test_an_argument_that_a_shell_works_out_is_left_out_whole(tree: Tree) -> None:
    page = "# Run\nros2 launch demo map.launch.py file:='$(find-pkg-share demo)/a.yaml' robot:=a\n"
    assert tree({**ROS2, "README.md": page}).command == ("ros2", "launch", "demo", "map.launch.py", "robot:=a")


def test_the_page_of_a_copied_package_says_nothing_about_the_whole(tree: Tree) -> None:
    def package(folder: str, name: str) -> dict[str, str]:
        xml = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
        made = f"project({name})\nfind_package(catkin REQUIRED)\n"
        return {
            f"{folder}/package.xml": xml,
            f"{folder}/CMakeLists.txt": made,
            f"{folder}/launch/{name}.launch": "<launch/>",
        }

    own = package("src/planner", "planner") | package("src/terrain", "terrain") | {"README.md": "See our page.\n"}
    copied = package("src/lidar", "lidar") | {"src/lidar/README.md": "```\nroslaunch lidar lidar.launch\n```\n"}
    assert tree(own | copied).command == ("roslaunch", "lidar", "lidar.launch")
    assert tree(own | copied | {"src/lidar/LICENSE": "BSD"}).command == ("bash",)
    both = {"src/terrain/LICENSE": "BSD", "src/terrain/README.md": "Terrain.\n"}
    assert tree(own | copied | both | {"src/lidar/LICENSE": "BSD"}).command == ("roslaunch", "lidar", "lidar.launch")


@pytest.mark.parametrize(
    ("start", "command"),
    [
        ("torchpack dist-run -np 8 python tools/a.py b.yaml", "python tools/a.py b.yaml"),
        ("accelerate launch --num_processes 2 tools/a.py b.yaml", "python tools/a.py b.yaml"),
        ("horovodrun -np 4 -H localhost:4 python tools/a.py", "python tools/a.py"),
        ("torchpack convert tools/a.py", "bash"),
    ],
)
def test_what_starts_a_program_on_several_gpus_is_not_the_program(tree: Tree, start: str, command: str) -> None:
    files = {"tools/a.py": "import torch\n", "b.yaml": "a: 1\n", "README.md": f"# Run\n```\n{start}\n```\n"}
    assert " ".join(tree(files).command) == command


def test_a_script_beside_a_library_is_no_program_of_it(tree: Tree) -> None:
    main = "import numpy\nif __name__ == '__main__':\n    pass\n"
    own = "[project]\nname = 'swing'\nversion = '1'\ndependencies = ['numpy']\n"
    assert tree({"pyproject.toml": own, "scripts/gather.py": main}).command == ("bash",)
    assert tree({"pyproject.toml": own, "scripts/gather.py": main, "simulate.py": main}).command[1] == "simulate.py"


@pytest.mark.parametrize(("page", "command"), [("README.md", "python3"), ("scripts/README.md", "bash")])
def test_a_script_of_no_package_is_run_where_the_page_at_the_root_says_so(tree: Tree, page: str, command: str) -> None:
    xml = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    files = {f"src/{name}/package.xml": xml.format(name) for name in ("arm", "leg")}
    files |= {f"src/{name}/CMakeLists.txt": "project(a)\nfind_package(ament_cmake)\n" for name in ("arm", "leg")}
    files |= {f"src/arm/launch/{name}.launch.py": "from launch import LaunchDescription\n" for name in ("a", "b")}
    script = {"scripts/send_robots.py": "import numpy\nif __name__ == '__main__':\n    pass\n"}
    assert tree({**files, **script, page: "```\npython3 scripts/send_robots.py nuc1\n```\n"}).command[0] == command


@pytest.mark.parametrize(
    ("code", "page", "command"),
    [
        ("open('../data/a.dat')", "cd demo/src/\n```\n```\npython3 main.py", "cd src && exec python3 main.py"),
        ("open(f'../data/{i}.dat')", "cd src\npython3 main.py -n 1", "cd src && exec python3 main.py -n 1"),
        ("open('a.yaml')", "cd src\npython3 main.py ../data/a.dat", "cd src && exec python3 main.py ../data/a.dat"),
        ("open('../data/a.dat')", "python3 src/main.py", "python3 src/main.py"),
        ("open('a.yaml')", "python3 main.py", "cd src && exec python3 main.py"),
        ("print(1)", "python3 main.py", "python3 src/main.py"),
        ("open('data/a.dat')", "cd src\npython3 main.py", "python3 src/main.py"),
        ("print(1)", "cd src\npython3 main.py", "python3 src/main.py"),
    ],
)
def test_a_program_is_started_in_the_folder_that_its_paths_begin_in(
    tree: Tree, code: str, page: str, command: str
) -> None:
    files = {"src/main.py": "import tools\n", "src/tools.py": f"{code}\n", "src/a.yaml": "", "data/a.dat": ""}
    found = tree({**files, "requirements.txt": "numpy\n", "README.md": f"# Usage\n```\n{page}\n```\n"}).command
    assert (found if isinstance(found, str) else " ".join(found)) == command


_JOINED = "here = os.path.dirname(os.path.realpath(__file__))\nopen(os.path.join(here, '../data/a.dat'))"
_DIRECT = "open(os.path.join(os.path.dirname(__file__),\n    '../data/a.dat'))"


@pytest.mark.parametrize(
    ("program", "beside", "page", "command"),
    [
        ("open('./data/a.dat')", "open('../data/a.dat')", "python3 main.py", "python3 src/main.py"),
        ("open('./data/a.dat')", "open('../data/a.dat')", "cd src\npython3 main.py", "cd src && exec python3 main.py"),
        ("open('./data/a.dat')\nopen('a.yaml')", "", "python3 main.py", "cd src && exec python3 main.py"),
        ("print(1)", "open('../data/a.dat')", "python3 main.py", "cd src && exec python3 main.py"),
        (_JOINED, "", "python3 main.py", "python3 src/main.py"),
        (_DIRECT, "", "python3 main.py", "python3 src/main.py"),
        ("open(Path(__file__).parent / '../data/a.dat')", "", "python3 main.py", "python3 src/main.py"),
        ("open(os.path.join(root, '../data/a.dat'))", "", "python3 main.py", "cd src && exec python3 main.py"),
        (f"{_JOINED}\nopen('../data/b.dat')", "", "python3 main.py", "cd src && exec python3 main.py"),
        ("open('a.yaml')", "", "python3 main.py\npython3 ./src/main.py -v", "python3 src/main.py"),
        ("open('a.yaml')", "", "cd src\npython3 main.py\ncd ..\npython3 src/main.py", "cd src && exec python3 main.py"),
        ("open('a.yaml')", "", "python3 main.py\npython3 src/tools.py", "cd src && exec python3 main.py"),
    ],
)
def test_a_program_is_started_where_its_page_and_its_own_paths_say_before_those_beside_it(
    tree: Tree, program: str, beside: str, page: str, command: str
) -> None:
    files = {
        "src/main.py": f"import tools\n{program}\n",
        "src/tools.py": f"{beside}\n",
        "src/a.yaml": "",
        "data/a.dat": "",
    }
    found = tree({**files, "requirements.txt": "numpy\n", "README.md": f"# Usage\n```\n{page}\n```\n"}).command
    assert (found if isinstance(found, str) else " ".join(found)) == command


def test_a_sentence_before_a_command_with_a_path_starts_nothing_elsewhere(tree: Tree) -> None:
    page = "# Usage\n\nTo train it, run `train.py` as you like:\n\n```\npython ./tools/train.py\n```\n"
    files = {"tools/train.py": "open('a.yaml')\n", "tools/a.yaml": "", "requirements.txt": "numpy\n", "README.md": page}
    assert tree(files).command == ("python", "tools/train.py")


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("cd scripts/\n./main.sh a.yaml", "cd scripts && exec bash main.sh a.yaml"),
        ("cd scripts\n./build.sh\n```\nThen\n```\ncd scripts\nbash main.sh", "cd scripts && exec bash main.sh"),
        ("cd ~/ws/src/demo/scripts\nsh main.sh", "cd scripts && exec bash main.sh"),
        ("cd build\n./start.sh", "bash start.sh"),
        ("./scripts/main.sh", "bash scripts/main.sh"),
        ("roscd demo/scripts\n./main.sh", "cd scripts && exec bash main.sh"),
        ("roscd demo/scripts\n./show_it", "cd scripts && exec bash show_it"),
        ("cd scripts\n./show_it", "cd scripts && exec bash show_it"),
        ("roscd demo\n./main_node\nroslaunch demo map.launch", "roslaunch demo map.launch"),
        ("cd scripts\n./gone.sh\nroslaunch demo map.launch", "roslaunch demo map.launch"),
    ],
)
def test_a_script_is_started_in_the_folder_that_the_page_goes_to(tree: Tree, page: str, command: str) -> None:
    scripts = dict.fromkeys(
        ("scripts/main.sh", "scripts/build.sh", "scripts/show_it", "start.sh"), "roslaunch demo map.launch\n"
    )
    found = tree({**ROS1, **scripts, "README.md": f"# Run\n```\n{page}\n```\n"}).command
    assert (found if isinstance(found, str) else " ".join(found)) == command


@pytest.mark.parametrize(
    ("last", "command"),
    [
        ("${SHELL} --rcfile ${file}", "roslaunch demo map.launch"),
        ("exec bash -i", "roslaunch demo map.launch"),
        ("exec /bin/bash", "roslaunch demo map.launch"),
        ("gnome-terminal -- bash -c 'roslaunch demo map.launch; exec bash'", "bash robot.sh master"),
        ("exec roslaunch demo map.launch", "bash robot.sh master"),
        ("read -s password\nroslaunch demo map.launch", "roslaunch demo map.launch"),
        ("  read -r -sp 'Password: ' password\nroslaunch demo map.launch", "roslaunch demo map.launch"),
        ("read -s -n 1 -p 'any key'\nroslaunch demo map.launch", "bash robot.sh master"),
        ("git submodule add https://github.com/lab/arm.git arm", "roslaunch demo map.launch"),
        ("git submodule init\ngit submodule update", "roslaunch demo map.launch"),
        ("git submodule init\nroslaunch demo map.launch", "bash robot.sh master"),
    ],
)
def test_a_script_that_opens_a_shell_is_not_what_is_run(tree: Tree, last: str, command: str) -> None:
    page = "# Usage\nOpen a shell with `./robot.sh master`, then\n```\nroslaunch demo map.launch\n```\n"
    script = f"#!/bin/bash\nexport ROBOT=$1\n{last}\n"
    assert " ".join(tree({**ROS1, "robot.sh": script, "README.md": page}).command) == command


@pytest.mark.parametrize(
    ("line", "command"),
    [
        ('RUN="docker run -it demo:latest"\n$RUN', "roslaunch demo map.launch"),
        ("cd .. && true\n  sudo docker build -t demo .", "roslaunch demo map.launch"),
        ("docker compose --file all.yml up", "roslaunch demo map.launch"),
        ("exec nvidia-docker run demo", "roslaunch demo map.launch"),
        ("# docker run demo starts it in a container\nroslaunch demo map.launch", "bash start.sh"),
        ("echo 'then docker run demo'\nroslaunch demo map.launch", "bash start.sh"),
    ],
)
def test_a_script_that_starts_a_container_is_not_what_is_run(tree: Tree, line: str, command: str) -> None:
    page = "# Run\n`./start.sh --fast`\n## Then\n```\nroslaunch demo map.launch\n```\n"
    found = tree({**ROS1, "start.sh": f"#!/bin/bash\n{line}\n", "README.md": page}).command
    assert " ".join(found).removesuffix(" --fast") == command


@pytest.mark.parametrize(
    ("guard", "command"),
    [
        ('if [ -z "$SIM_HOME" ]; then\n    echo "Please set it"\n    exit 1\nfi', "python main.py"),
        ('[[ -z "${SIM_HOME}" ]] && { echo "Please set it"; exit 1; }', "python main.py"),
        (': "${SIM_HOME:?is not set}"', "python main.py"),
        ('if [ -z "$SIM_HOME" ]; then\n    SIM_HOME=$(pwd)\nfi', "bash start.sh"),
        ('SIM_HOME=sim\nif [ -z "$SIM_HOME" ]; then\n    exit 1\nfi', "bash start.sh"),
        ('if [ -z "$SIM_HOME" ]; then\n    echo "the default"\nelse\n    echo "yours"; exit 1\nfi', "bash start.sh"),
        ('if [ -z "$HOME" ]; then\n    exit 1\nfi', "bash start.sh"),
    ],
)
def test_a_script_that_stops_without_a_variable_is_not_what_is_run(tree: Tree, guard: str, command: str) -> None:
    page = "# Usage\nStart the simulator:\n```\n./start.sh\n```\nThen\n```\npython main.py\n```\n"
    files = {"start.sh": f"#!/bin/bash\n{guard}\n./sim\n", "main.py": "import numpy\n", "README.md": page}
    assert " ".join(tree({**files, "requirements.txt": "numpy\n"}).command) == command


@pytest.mark.parametrize(
    ("script", "command"),
    [
        ("conda create -n demo python=3.10 -y\nconda activate demo\npip install -e .", "python main.py"),
        ("if true; then\n  sudo apt-get -y install ffmpeg\nfi\npython setup.py develop", "python main.py"),
        ("pip install -r requirements.txt\nexec python main.py --fast", "bash env/all.sh"),
        ("pip install numpy\nDISPLAY=:0 ./sim", "bash env/all.sh"),
        ("pip install numpy\nbuild/sim --fast", "bash env/all.sh"),
        ("echo 'pip install numpy if it is missing'", "bash env/all.sh"),
    ],
)
def test_a_script_that_only_installs_is_not_what_is_run(tree: Tree, script: str, command: str) -> None:
    page = "# Usage\n```\ncd env\n./all.sh\n```\nThen\n```\ncd ..\npython main.py\n```\n"
    files = {"env/all.sh": f"#!/bin/bash\n{script}\n", "main.py": "import numpy\n", "README.md": page}
    found = tree({**files, "requirements.txt": "numpy\n"}).command
    assert (found if isinstance(found, str) else " ".join(found)).replace(
        "cd env && exec bash ", "bash env/"
    ) == command


def test_what_a_sentence_uses_as_something_is_not_what_is_run(tree: Tree) -> None:
    page = "# Usage\nCopy and use `lib/demo.py` as a template, or use `other.py` to see it.\n"
    main = 'if __name__ == "__main__":\n    print(1)\n'
    found = tree({"lib/demo.py": main, "other.py": main, "third.py": main, "README.md": page})
    assert found.command == ("python", "other.py")


@pytest.mark.parametrize(
    ("said", "argv"),
    [
        ("--logdir ~/logs/run1 --n 3", ("--logdir", "logs/run1", "--n", "3")),
        ("--save_dir=~/logs --n 3", ("--save_dir=logs", "--n", "3")),
        ("logdir=~/logs/run1", ("logdir=logs/run1",)),
        ("--data ~/logs --n 3", ("--n", "3")),
        ("--n 3 DATA.ROOT ${ROOT} MODEL.SIZE 4", ("--n", "3", "MODEL.SIZE", "4")),
        ("--output /path/to/it --n 3", ("--n", "3")),
    ],
)
def test_what_a_program_writes_below_the_home_is_written_below_the_tree(
    tree: Tree, said: str, argv: tuple[str, ...]
) -> None:
    main = 'if __name__ == "__main__":\n    print(1)\n'
    assert tree({"run.py": main, "README.md": f"# Usage\n```\npython run.py {said}\n```\n"}).command[2:] == argv


def test_an_evaluation_that_is_written_out_comes_before_what_leaves_paths_to_the_reader(tree: Tree) -> None:
    main = 'if __name__ == "__main__":\n    print(1)\n'
    page = "## Launching Evaluations\n```\npython eval_sim.py --model lab/model\n```\n"
    page += "## Fine-Tuning\n```\npython train.py --data /path/to/data\n```\n"
    files = {"eval_sim.py": main, "train.py": main}
    assert tree({**files, "README.md": page}).command == ("python", "eval_sim.py", "--model", "lab/model")
    page = page.replace("Launching Evaluations", "Evaluation")
    assert tree({**files, "README.md": page}).command == ("python", "train.py")


def test_what_computes_numbers_for_the_training_is_not_what_is_run(tree: Tree) -> None:
    main = 'if __name__ == "__main__":\n    print(1)\n'
    page = "# Usage\n```\npython compute_norm_stats.py --config a\npython train.py --config a\n```\n"
    assert tree({"compute_norm_stats.py": main, "train.py": main, "README.md": page}).command[1] == "train.py"


@pytest.mark.parametrize(
    ("links", "program"), [("[a](SIM.md) [b](ROBOT.md)", "eval_sim.py"), ("[b](ROBOT.md) [a](SIM.md)", "serve.py")]
)
def test_an_evaluation_on_the_page_that_is_linked_to_first(tree: Tree, links: str, program: str) -> None:
    main = 'if __name__ == "__main__":\n    print(1)\n'
    pages = {
        "README.md": f"# Arm\n{links}\n",
        "SIM.md": "## Launching Evaluations\n```\npython eval_sim.py --model lab/model\n```\n",
        "ROBOT.md": "## Launching the server\n```\npython serve.py --checkpoint /path/to/it\n```\n",
    }
    assert tree({"eval_sim.py": main, "serve.py": main} | pages).command[1] == program


@pytest.mark.parametrize(
    ("title", "launched"),
    [
        ("3. Start the demo simulation to test your setup", "world"),
        ("Test the demo", "drive"),
        ("Run the tests", "drive"),
    ],
)
def test_what_a_section_starts_to_test_the_installation_is_run_first(tree: Tree, title: str, launched: str) -> None:
    page = f"# For ROS Noetic\n## {title}\n```roslaunch demo world.launch```\n"
    page += "## Start driving\n`roslaunch demo drive.launch`\n"
    files = {f"launch/{name}.launch": "<launch/>\n" for name in ("world", "drive")}
    found = tree({"package.xml": PACKAGE.format(tool="catkin"), "README.md": page} | files)
    assert found.command == ("roslaunch", "demo", f"{launched}.launch")


@pytest.mark.parametrize(
    ("said", "argv"),
    [
        ('--task "pick up the red block" --n 3', ("--task", "pick up the red block", "--n", "3")),
        ("--task='pick it up'", ("--task=pick it up",)),
        ('--task "<your task>" --n 3', ("--n", "3")),
        ('scene.yaml "put it away"', ("scene.yaml", "put it away")),
    ],
)
def test_what_a_page_quotes_is_one_word(tree: Tree, said: str, argv: tuple[str, ...]) -> None:
    main = 'if __name__ == "__main__":\n    print(1)\n'
    files = {"run.py": main, "scene.yaml": "a: 1\n", "README.md": f"# Usage\n```\npython run.py {said}\n```\n"}
    assert tree(files).command == ("python", "run.py", *argv)


@pytest.mark.parametrize(
    ("title", "name"), [("Start RViz in the Docker container", "map"), ("Start RViz with Docker", "replay")]
)
def test_what_is_started_inside_a_container_is_what_the_image_is_for(tree: Tree, title: str, name: str) -> None:
    """The second page shows more, with another launch file."""
    pages = {
        "README.md": "1. [Run](pages/a.md)\n2. [See](pages/b.md)\n",
        "pages/a.md": f"# {title}\n`roslaunch demo map.launch`\n",
        "pages/b.md": "# Goal Pose Visualization\n`roslaunch demo replay.launch`\n",
    }
    assert tree({**ROS1, **pages}).command == ("roslaunch", "demo", f"{name}.launch")


@pytest.mark.parametrize(
    ("elsewhere", "argv"),
    [
        ("roslaunch demo world.launch map:=hall", ("world.launch", "map:=hall")),
        ("roslaunch demo world.launch gui:=true", ("drive.launch",)),
    ],
)
def test_a_value_that_another_page_gives_leaves_no_gap(tree: Tree, elsewhere: str, argv: tuple[str, ...]) -> None:
    launch = {
        "launch/world.launch": '<launch><arg name="map"/><arg name="gui" default="false"/></launch>\n',
        "launch/drive.launch": "<launch/>\n",
    }
    pages = {
        "README.md": "# Usage\nroslaunch demo world.launch map:=<map>\nroslaunch demo drive.launch\n[a](INSTALL.md)\n",
        "INSTALL.md": f"# Docker\n`{elsewhere}`\n",
    }
    files = {"package.xml": PACKAGE.format(tool="catkin")}
    assert tree({**files, **launch, **pages}).command == ("roslaunch", "demo", *argv)


def test_what_cmake_would_compile_beside_a_package_of_python_is_no_program_of_the_image(tree: Tree) -> None:
    cmake = "cmake_minimum_required(VERSION 3.1)\nproject(points)\nadd_executable(viewer main.cpp)\n"
    files = {"setup.py": "from setuptools import setup\nsetup(name='points', install_requires=['numpy'])\n"}
    files |= {"CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", "points/__init__.py": "import numpy\n"}
    found = tree({**files, "README.md": "# Quickstart\n```\n>> import points\n```\n"})
    assert (found.kind, found.command) == ("python", ("bash",))


@pytest.mark.parametrize(
    ("place", "command"),
    [
        ("scripts", "cd scripts && exec bash run-demo.sh"),
        ("install/scripts", "align -h"),
        ("build/install", "align -h"),
    ],
)
def test_a_script_of_what_is_installed_is_not_started_in_the_source(tree: Tree, place: str, command: str) -> None:
    page = f"## Use\n```\nmake install\ncd {place}\n./run-demo.sh\n```\nThen\n```\n./align -h\n```\n"
    files = {
        "CMakeLists.txt": "project(demo CXX)\nadd_executable(align a.cpp)\nadd_executable(show a.cpp)\n",
        "a.cpp": "int main() {}\n",
        "scripts/run-demo.sh": "../bin/align a b\n",
        "README.md": page,
    }
    found = tree(files).command
    assert (found if isinstance(found, str) else " ".join(found)) == command


def test_a_script_that_gets_the_sister_packages_is_no_default(tree: Tree) -> None:
    page = "```\n./get_repos.sh\nros2 launch demo map.launch.py\n```\n"
    files = {**ROS2, "README.md": page, "get_repos.sh": "vcs import src < demo.repos\n"}
    assert tree(files).command == ("ros2", "launch", "demo", "map.launch.py")


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("--gpus NUM_GPUS", ()),
        ("--nproc_per_node=NUM_GPUS --seed SEED", ()),
        ("--batch BATCH_SIZE --epochs 2", ("--epochs", "2")),
        ("train.seed=SEED", ()),
        ("--cfg NUM_GPUS 8", ("--cfg", "NUM_GPUS", "8")),
        ("--dataset CIFAR --model SAC_X", ("--dataset", "CIFAR", "--model", "SAC_X")),
    ],
)
def test_a_name_in_capitals_for_what_an_option_is(tree: Tree, said: str, left: tuple[str, ...]) -> None:
    files = {"README.md": f"```\npython train.py {said}\n```\n", "train.py": "import numpy\n"}
    assert tree(files).command == ("python", "train.py", *left)


@pytest.mark.parametrize("name", ["pre_process_kitti", "preprocess", "pre-process", "preproc_scans"])
def test_what_prepares_the_data_is_not_what_is_meant(tree: Tree, name: str) -> None:
    page = f"# Net\n```\npython {name}.py\n```\n# Training\n```\npython train.py\n```\n"
    program = 'import numpy\nif __name__ == "__main__":\n    pass\n'
    decision = tree({"README.md": page, f"{name}.py": program, "train.py": program})
    assert decision.command == ("python", "train.py")


def test_a_name_that_only_begins_so_may_be_meant(tree: Tree) -> None:
    page = "# Net\n```\npython process.py\n```\n# Training\n```\npython train.py\n```\n"
    program = 'import numpy\nif __name__ == "__main__":\n    pass\n'
    decision = tree({"README.md": page, "process.py": program, "train.py": program})
    assert ("python", "process.py") in decision.command_candidates


@pytest.mark.parametrize("call", ["python sim/show.py", "python -m sim.show"])
def test_a_window_of_the_program_however_it_is_started(tree: Tree, call: str) -> None:
    code = "import pybullet as p\nif __name__ == '__main__':\n    p.connect(p.GUI)\n"
    files = {
        "sim/show.py": code,
        "requirements.txt": "pybullet\n",
        "setup.py": "from setuptools import setup\nsetup(name='sim', packages=['sim'])\n",
    }
    decision = tree({**files, "sim/__init__.py": "", "README.md": f"# Run\n```\n{call}\n```\n"})
    assert (" ".join(decision.command), decision.gui) == (call, True)


@pytest.mark.parametrize(("others", "script"), [(2, True), (12, False)])
def test_the_page_of_one_package_among_many_chooses_no_script(tree: Tree, others: int, script: bool) -> None:
    files = {"src/gen/scripts/message.py": "if __name__ == '__main__':\n    print(1)\n"}
    files["src/gen/README"] = "./scripts/message.py -p a -Ia:`rospack find a`/msg `rospack find b`/msg/B.msg\n"
    for name in ("gen", *(f"part_{number}" for number in range(others))):
        xml = f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend></package>"
        files[f"src/{name}/package.xml"] = xml
        files[f"src/{name}/CMakeLists.txt"] = f"project({name})\nfind_package(catkin REQUIRED)\n"
    made = tree(files)
    assert any("message.py" in word for word in made.command) == script
    assert "rospack" not in " ".join(made.command)


@pytest.mark.parametrize(
    ("starts", "command"),
    [
        ('["roslaunch", "radar", "radar.launch"]', ("python3", "main.py")),
        ('["roslaunch", "elsewhere", "radar.launch"]', ("roslaunch", "radar", "radar.launch")),
    ],
)
def test_a_script_beside_packages_that_starts_one_is_what_the_page_runs(
    tree: Tree, starts: str, command: tuple[str, ...]
) -> None:
    xml = "<package><name>radar</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {
        "README.md": "# ROS Noetic\n```\ncatkin_make\n```\n# Usage\n```\npython3 main.py\n```\n",
        "main.py": f"import subprocess\nsubprocess.Popen({starts})\n",
        "src/radar/package.xml": xml,
        "src/radar/CMakeLists.txt": "project(radar)\nfind_package(catkin REQUIRED)\n",
        "src/radar/README.md": "# Usage\n```\nroslaunch radar radar.launch\n```\n",
        "src/radar/launch/radar.launch": '<launch><node pkg="rospy_tutorials" type="talker" name="talker"/></launch>\n',
    }
    assert tree(files).command == command


HERE = "https://github.com/lab/demo/tree/main"


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (f"Shows [odometry]({HERE}/second/README.md) and [maps](first/README.md).\n", "odometry"),
        ("Shows [odometry](second/).\n", "odometry"),
        ("Shows [the licence](third/README.md).\n", "map"),
        ("Shows [odometry](second/README.md).\n```\nroslaunch demo replay.launch\n```\n", "replay"),
        ("Nothing.\n", "map"),
    ],
)
def test_pages_of_equal_depth_come_in_the_order_of_the_links_to_them(tree: Tree, page: str, command: str) -> None:
    pages = {
        "README.md": page,
        "first/README.md": "```\nroslaunch demo map.launch\n```\n",
        "second/README.md": "```\n$ $ roslaunch demo odometry.launch\n```\n",
    }
    assert tree({**ROS1, **pages}).command == ("roslaunch", "demo", f"{command}.launch")


@pytest.mark.parametrize(
    ("name", "makes_one"),
    [
        ("onnx2trt", True),
        ("pt2onnx", True),
        ("onnx_to_trt", True),
        ("torch_2_onnx", True),
        ("torch2_onnx", True),
        ("to_tensorrt", True),
        ("onnx2trt_v8", True),
        ("depth_anything_v2_trt", False),
        ("auto_engine", False),
        ("yolov2_onnx", False),
        ("sam2_onnx", False),
        ("ros2_tensorrt", False),
        ("yolo_ros2_trt", False),
        ("crypto_engine", False),
        ("photo_engine", False),
    ],
)
def test_what_runs_a_model_is_no_converter(tree: Tree, name: str, *, makes_one: bool) -> None:
    page = f"# Net\n## Run\n```\npython {name}.py --input a\n```\n"
    script = "import numpy\nif __name__ == '__main__':\n    print(1)\n"
    decision = tree({"README.md": page, "requirements.txt": "numpy\n", f"{name}.py": script, "tool.py": script})
    assert " ".join(decision.command) == ("bash" if makes_one else f"python {name}.py --input a")


def test_a_configurator_is_a_program_to_work_with(tree: Tree) -> None:
    files = {
        "start_configurator.py": "import six\nsix.go()\n",
        "demo/b.py": "if __name__ == '__main__':\n    print(1)\n",
    }
    page = "# GUI\n```\npython start_configurator.py\n```\n"
    assert tree({**files, "README.md": page}).command == ("python", "start_configurator.py")
