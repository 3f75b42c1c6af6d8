"""Options that a page has catkin_tools keep, before it builds."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}


@pytest.mark.parametrize(
    ("page", "options"),
    [
        ("catkin config --cmake-args -DBUILD_SHARED_LIBS=0\ncatkin build", ("-DBUILD_SHARED_LIBS=0",)),
        (
            "catkin config -a --cmake-args -DWITH_A=ON\ncatkin build --cmake-args -DWITH_B=ON",
            ("-DWITH_A=ON", "-DWITH_B=ON"),
        ),
        ("catkin config -DWITH_A=ON && catkin build -DWITH_A=OFF", ("-DWITH_A=OFF",)),
        ("catkin config --cmake-args -DCMAKE_BUILD_TYPE=Release\ncatkin build", ()),
        ("catkin config --profile trial --cmake-args -DWITH_A=ON\ncatkin build", ()),
        ("catkin config -DUSE_CUDA=ON\ncatkin build", ()),  # for machines with a GPU
        ("catkin build\ncatkin config -DWITH_COVERAGE=ON", ()),  # for what is built later
        ("catkin config -DWITH_A=ON", ()),  # nothing is built with it
        ("catkin_make -DWITH_B=ON", ("-DWITH_B=ON",)),
    ],
)
def test_they_are_given_to_the_build(tree: Tree, page: str, options: tuple[str, ...]) -> None:
    assert tree({**FILES, "README.md": f"# demo\n\nROS Noetic\n\n```\n{page}\n```\n"}).cmake_options == options


@pytest.mark.parametrize(
    ("files", "options"),
    [
        ({"setup.sh": "catkin init\ncatkin build --cmake-args -DWITH_B=ON\n"}, ("-DWITH_B=ON",)),
        ({"setup.sh": "catkin build -DCMAKE_BUILD_TYPE=Debug\n"}, ()),
        ({"tools/setup.sh": "catkin build -DWITH_A=ON\n"}, ()),
        ({"fast.sh": "catkin build -DWITH_A=ON\n", "slow.sh": "catkin build -DWITH_A=OFF\n"}, ()),
        ({"setup.sh": "catkin build -DWITH_A=ON\n", "README.md": "ROS Noetic\n\n```\ncatkin build\n```\n"}, ()),
    ],
)
def test_where_no_page_builds_those_of_the_one_script_are_given(
    tree: Tree, files: dict[str, str], options: tuple[str, ...]
) -> None:
    page = {"README.md": "# demo\n\nROS Noetic\n\n```\n./setup.sh\n```\n", "CMakeLists.txt": FILES["CMakeLists.txt"]}
    assert tree({**FILES, **page, **files}).cmake_options == options
