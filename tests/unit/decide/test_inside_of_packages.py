"""A library of plain CMake that a package of ROS below it links by its file is compiled before the workspace."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>slam_ros</name><buildtool_depend>catkin</buildtool_depend></package>"
LIBRARY = (
    "project(SLAM)\nset(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_SOURCE_DIR}/lib)\n"
    "add_library(${PROJECT_NAME} SHARED a.cc)\n"
)
NODE = (
    "project(slam_ros)\nfind_package(catkin REQUIRED)\ncatkin_package()\nadd_executable(mono a.cc)\n"
    "target_link_libraries(mono ${{PROJECT_SOURCE_DIR}}/../../../lib/lib{name}.so)\n"
)
SCRIPT = "mkdir build\ncd build\ncmake .. -DWITH_GUI=OFF\nmake -j\n"


def files(above: str, name: str = "SLAM") -> dict[str, str]:
    return {
        f"{above}CMakeLists.txt": LIBRARY,
        f"{above}build.sh": SCRIPT,
        f"{above}Examples/ROS/slam/package.xml": PACKAGE,
        f"{above}Examples/ROS/slam/CMakeLists.txt": NODE.format(name=name),
        "README.md": f"ROS Kinetic\n\n```\n{f'cd {above}' if above else ''}\n./build.sh\n```\n",
    }


@pytest.mark.parametrize(
    ("tree_of", "found"),
    [
        (files("slam/"), (("slam", "-DWITH_GUI=OFF"),)),
        (files(""), (("", "-DWITH_GUI=OFF"),)),
        ({**files("slam/"), "README.md": "ROS Kinetic\n"}, (("slam", ""),)),
        (files("slam/", name="other"), ()),
        ({**files(""), "lib/libSLAM.so": "built"}, ()),
    ],
)
def test_the_library_around_a_package(tree: Tree, tree_of: dict[str, str], found: object) -> None:
    assert tree(tree_of).inside == found


def test_the_library_of_the_root(tmp_path: Path) -> None:
    for path, text in files("").items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert 0 < text.index("-DWITH_GUI=OFF") < text.index("# The workspace")
    assert "//build" not in text
