"""An OpenCV that is compiled has those modules of opencv_contrib that the code includes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Source
from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def _opencv(tree: Tree, headers: str, find: str = "OpenCV 4.5", folder: str = "") -> Source:
    cmake = f"project(demo)\nfind_package(catkin REQUIRED)\nfind_package({find} REQUIRED)\nadd_executable(demo a.cpp)\n"
    code = "".join(f"#include <opencv2/{header}.hpp>\n" for header in headers.split())
    files = {"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": "ROS Noetic\n", "package.xml": PACKAGE}
    decision = tree(files | {f"{folder}b.hpp": code})
    (source,) = [each for each in decision.source if each.name == "opencv"]
    return source


@pytest.mark.parametrize(
    ("headers", "moved"),
    [
        ("xfeatures2d", "xfeatures2d"),
        ("xfeatures2d/nonfree", "xfeatures2d"),
        ("core tracking/tracker", "plot tracking"),
        ("aruco superres", "aruco optflow ximgproc superres"),
    ],
)
def test_what_the_code_includes_is_compiled_with_what_it_needs(tree: Tree, headers: str, moved: str) -> None:
    source = _opencv(tree, headers)
    assert source.prepare == (
        f"git clone --quiet --depth 1 --branch {source.ref} https://github.com/opencv/opencv_contrib.git .contributed"
        f" && mv {' '.join(f'.contributed/modules/{name}' for name in moved.split())} modules/ && rm -rf .contributed"
    )
    assert ("-DOPENCV_ENABLE_NONFREE=ON" in source.cmake_options) == ("nonfree" in headers)


def test_its_own_modules_need_no_other_repository(tree: Tree) -> None:
    assert not _opencv(tree, "core highgui/highgui video/tracking").prepare


def test_what_a_library_of_the_tree_includes_is_its_own_matter(tree: Tree) -> None:
    assert not _opencv(tree, "aruco", folder="third_party/other/").prepare


def test_opencv_3_has_what_moved_later_itself(tree: Tree) -> None:
    source = _opencv(tree, "shape xfeatures2d", find="OpenCV 3.4")
    assert (source.ref or "").startswith("3.4")
    assert ".contributed/modules/xfeatures2d modules/" in source.prepare
    assert "shape" not in source.prepare
