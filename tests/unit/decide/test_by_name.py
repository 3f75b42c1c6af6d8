"""Programs that a package installs into bin, where rosrun and ros2 run do not look: they are called by their names."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
NODE = {
    "node/package.xml": "<package><name>node</name><buildtool_depend>catkin</buildtool_depend></package>",
    "node/CMakeLists.txt": "project(node)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
}
PLAIN = "<package format='2'><name>tool</name>{}<export><build_type>{}</build_type></export></package>"


def of(install: str, build_type: str = "cmake", page: str = "catkin build\nrosrun tool solve --fast") -> dict[str, str]:
    needs = {"ament_cmake": "<buildtool_depend>ament_cmake</buildtool_depend>"}.get(build_type, "")
    needs = "<buildtool_depend>catkin</buildtool_depend>" if build_type == "catkin" else needs
    ends = {"ament_cmake": "find_package(ament_cmake REQUIRED)\nament_package()\n", "cmake": ""}
    code = f"project(tool)\nadd_executable(solve src/solve.cpp)\n{install}\n"
    return {
        "tool/package.xml": PLAIN.format(needs, build_type),
        "tool/CMakeLists.txt": code + ends.get(build_type, "find_package(catkin REQUIRED)\ncatkin_package()\n"),
        "tool/src/solve.cpp": "int main() {}\n",
        "README.md": f"ROS {'Humble' if 'ros2' in page else 'Noetic'}\n```\n{page}\n```\n",
    } | ({each: text.replace("catkin", "ament_cmake") for each, text in NODE.items()} if "ros2" in page else NODE)


@pytest.mark.parametrize(
    ("install", "named"),
    [
        ("install(TARGETS solve DESTINATION bin)", True),
        ("install(TARGETS solve RUNTIME DESTINATION bin LIBRARY DESTINATION lib)", True),
        ("install(TARGETS solve LIBRARY DESTINATION lib RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})", True),
        ("install(TARGETS solve EXPORT tool DESTINATION ${CMAKE_INSTALL_PREFIX}/bin)", True),
        ("install(TARGETS solve)", True),
        ("set(OUT bin)\ninstall(TARGETS solve DESTINATION ${OUT})", True),
        ("install(TARGETS solve DESTINATION lib/${PROJECT_NAME})", False),
        ("install(TARGETS solve DESTINATION bin)\ninstall(TARGETS solve DESTINATION lib/tool)", False),
        ("if(WITH)\ninstall(TARGETS solve DESTINATION bin)\nendif()", False),
        ("add_executable(other src/solve.cpp)\ninstall(TARGETS other DESTINATION bin)", False),
        ("", False),
    ],
)
def test_a_program_of_plain_cmake(tree: Tree, install: str, *, named: bool) -> None:
    decision = tree(of(install))
    assert decision.command == (("solve", "--fast") if named else ("rosrun", "tool", "solve", "--fast"))
    assert "tool" in decision.must_build
    (why,) = [each for each in decision.reasons if each.question == "command" and each.decisive]
    assert ("installs it into bin" in why.reason) == named
    assert (why.file, why.line) == ("README.md", 4)


INSTALL = "install(TARGETS solve DESTINATION bin)"


def test_catkin_has_its_programs_where_rosrun_looks(tree: Tree) -> None:
    assert tree(of(INSTALL, "catkin")).command == ("rosrun", "tool", "solve", "--fast")


@pytest.mark.parametrize("build_type", ["cmake", "ament_cmake"])
def test_programs_of_ros_2(tree: Tree, build_type: str) -> None:
    page = "colcon build\nros2 run tool solve --fast"
    assert tree(of(INSTALL, build_type, page)).command == ("solve", "--fast")
    kept = of(INSTALL.replace("bin", "lib/tool"), build_type, page)
    assert tree(kept).command == ("ros2", "run", "tool", "solve", "--fast")


def test_what_nobody_mentions(tree: Tree) -> None:
    assert tree(of(INSTALL, page="catkin build")).command == ("solve",)
