"""A launch file that its package does not install is started by its path."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.launch_calls import as_found

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "eye/package.xml": '<package format="3"><name>eye</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>",
    "eye/CMakeLists.txt": "project(eye)\nfind_package(ament_cmake REQUIRED)\nadd_executable(node a.cpp)\n"
    "install(TARGETS node DESTINATION lib/eye)\n{}ament_package()\n",
    "eye/launch/see.launch.py": "def generate_launch_description():\n"
    "    return LaunchDescription([Node(package='eye', executable='node')])\n",
    "eye/a.cpp": "",
}
INSTALLS = "install(DIRECTORY launch DESTINATION share/eye)\n"
CONFIG = "install(DIRECTORY config DESTINATION share/eye)\n"
PATH = "ros2 launch eye/launch/see.launch.py"


def test_of_two_packages_that_of_the_named_one_is_started(tree: Tree) -> None:
    files = {path: text.format("") if path.endswith(".txt") else text for path, text in FILES.items()}
    files |= {path.replace("eye", "arm"): text.replace("eye", "arm") for path, text in files.items()}
    page = "# Eye\nFor ROS Humble.\n## Usage\n```\nros2 launch {} see.launch.py\n```\n"
    for name in ("eye", "arm"):
        command = tree({**files, "README.md": page.format(name)}).command
        assert " ".join(command) == f"ros2 launch {name}/launch/see.launch.py"


@pytest.mark.parametrize(
    ("installs", "page", "command"),
    [
        ("", "", PATH),
        (INSTALLS, "", "ros2 launch eye see.launch.py"),
        ("", "ros2 launch eye see.launch.py", PATH),
        ("", "ros2 launch eye see.launch.py rate:=5", f"{PATH} rate:=5"),
        ("", "ros2 launch eye/launch/see.launch.py", PATH),
        (INSTALLS, "ros2 launch eye see.launch.py rate:=5", "ros2 launch eye see.launch.py rate:=5"),
        (f"# {INSTALLS}{CONFIG}", "ros2 launch eye see.launch.py rate:=5", f"{PATH} rate:=5"),
        (CONFIG, "ros2 launch eye/launch/see.launch.py", PATH),
    ],
)
def test_the_call_of_a_launch_file(tree: Tree, installs: str, page: str, command: str) -> None:
    files = FILES | {"eye/CMakeLists.txt": FILES["eye/CMakeLists.txt"].format(installs)}
    readme = f"# Eye\nFor ROS Humble.\n## Usage\n```\n{page}\n```\n"
    assert " ".join(tree({**files, "README.md": readme}).command) == command


def test_an_option_may_stand_before_its_name() -> None:
    path = "eye/launch/see.launch.py"
    words = ("eye", "--debug", "see.launch.py", "a:=1")
    assert as_found(words, {("eye", "see.launch.py"): path}) == ("--debug", path, "a:=1")
    assert as_found(words, {("arm", "see.launch.py"): path}) == words


@pytest.mark.parametrize(
    ("written", "command"),
    [
        ("eye/launch/see.launch.py", "ros2 launch eye see.launch.py"),
        ("./src/robot/eye/launch/see.launch.py rate:=5", "ros2 launch eye see.launch.py rate:=5"),
        ("launch/see.launch.py", "ros2 launch eye see.launch.py"),
        ("launch/gone.launch.py", "bash"),
        ("see.launch.py", "bash"),  # the sentence may be about it
    ],
)
def test_a_page_starts_one_of_several_by_its_path(tree: Tree, written: str, command: str) -> None:
    cmake = FILES["eye/CMakeLists.txt"].format(INSTALLS)
    other = {"eye/launch/other.launch.py": FILES["eye/launch/see.launch.py"]}
    readme = f"# Eye\nFor ROS Humble.\n## Usage\n```\nros2 launch {written}\n```\n"
    found = tree({**FILES, **other, "eye/CMakeLists.txt": cmake, "README.md": readme}).command
    assert " ".join(found or ("bash",)) == command
