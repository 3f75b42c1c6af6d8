"""colcon is told of packages below a project of plain CMake, where it does not look by itself."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.plan.workspace import workspace
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
NODE = {
    "ros/arm/package.xml": "<package><name>arm</name><depend>rclcpp</depend>"
    "<export><build_type>ament_cmake</build_type></export></package>",
    "ros/arm/CMakeLists.txt": "project(arm)\nfind_package(ament_cmake REQUIRED)\nadd_executable(arm a.cpp)\n"
    "install(TARGETS arm DESTINATION lib/arm)\nament_package()\n",
    "ros/arm/a.cpp": "int main() {}\n",
}
LIBRARY = "cmake_minimum_required(VERSION 3.8)\nproject(planner CXX)\nadd_executable(plan p.cpp)\n"
INSTALLED = LIBRARY.replace("executable", "library") + "install(FILES plannerConfig.cmake DESTINATION share/planner)\n"
NEEDS = NODE["ros/arm/CMakeLists.txt"].replace("ament_package", "find_package(planner REQUIRED)\nament_package")
CATKIN = "cmake_minimum_required(VERSION 2.8.3)\nproject(Project)\ncatkin_workspace()\n"


@pytest.mark.parametrize(
    ("files", "hidden", "ignored"),
    [
        ({}, (), ()),
        ({"CMakeLists.txt": LIBRARY}, ("ros/arm",), ("",)),
        ({"ros/CMakeLists.txt": LIBRARY}, ("ros/arm",), ("ros",)),
        ({"CMakeLists.txt": INSTALLED, "ros/arm/CMakeLists.txt": NEEDS}, ("ros/arm",), ()),
        ({"CMakeLists.txt": LIBRARY + "add_subdirectory(ros/arm)\n"}, (), ()),
        ({"ros/CMakeLists.txt": CATKIN}, (), ()),
        ({"lib/CMakeLists.txt": LIBRARY}, (), ()),
    ],
    ids=["none", "root", "above", "needed", "added", "catkin", "beside"],
)
def test_colcon_is_told_of_what_it_does_not_come_to(
    tree: Tree, files: dict[str, str], hidden: tuple[str, ...], ignored: tuple[str, ...]
) -> None:
    decision = tree({**NODE, "p.cpp": "int main() {}\n", "lib/p.cpp": "", "ros/p.cpp": "", **files})
    assert decision.kind == "ros2"
    assert decision.hidden == hidden
    assert decision.ignored == ignored
    assert any(each.message.startswith("not built, for no package") for each in decision.warnings) is bool(ignored)


@pytest.mark.parametrize(
    ("place", "cmake", "arguments"),
    [
        ("ros", NODE["ros/arm/CMakeLists.txt"], ("src", "src/repo/ros/arm")),
        ("src", NODE["ros/arm/CMakeLists.txt"], ("src", "src/arm")),
        ("src", NEEDS, (".", "src/arm")),
    ],
)
def test_the_folders_are_arguments_of_colcon(tree: Tree, place: str, cmake: str, arguments: tuple[str, ...]) -> None:
    """Where the repository is the workspace, clones that lie beside its packages are found, too."""
    node = {path.replace("ros/", f"{place}/"): text for path, text in {**NODE, "ros/arm/CMakeLists.txt": cmake}.items()}
    build = workspace(tree({**node, "p.cpp": "", "CMakeLists.txt": INSTALLED}), Config(), (), "repo").ros
    assert build
    assert build.arguments == ("--base-paths", *arguments)


def test_what_the_command_starts_is_built(tmp_path: Path) -> None:
    files = {**NODE, "p.cpp": "int main() {}\n", "CMakeLists.txt": LIBRARY}
    decision = decided(tmp_path, files, config=Config(command=("../build/planner/plan", "--fast")))
    assert (decision.hidden, decision.ignored) == (("ros/arm",), ())


@pytest.mark.parametrize("words", [("--base-paths", "src/repo/ros"), ("--base-paths=src/repo/ros",)])
def test_where_roslab_yaml_tells_colcon_to_look_it_looks(tmp_path: Path, words: tuple[str, ...]) -> None:
    files = {**NODE, "p.cpp": "", "CMakeLists.txt": LIBRARY}
    decision = decided(tmp_path, files, config=Config(build_args=words))
    assert (decision.hidden, decision.ignored) == ((), ())


def test_catkin_looks_below_by_itself(tree: Tree) -> None:
    files = {
        "CMakeLists.txt": LIBRARY,
        "p.cpp": "int main() {}\n",
        "ros/arm/package.xml": "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
        "ros/arm/CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    }
    decision = tree(files)
    assert (decision.kind, decision.hidden, decision.ignored) == ("ros1", (), ())
