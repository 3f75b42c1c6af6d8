"""A header that the code includes chooses the release of a library from its source that has it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.native.has_include import asked_for

Tree = Callable[[dict[str, str]], Decision]
CPP = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package({} REQUIRED)\nadd_executable(demo a.cpp)\n"
ROS = (
    "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(catkin REQUIRED)\nfind_package({} REQUIRED)\n"
    "add_executable(demo a.cpp)\n"
)
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def built(decision: Decision) -> dict[str, str | None]:
    return {source.name: source.ref for source in decision.source}


@pytest.mark.parametrize(
    ("library", "header", "ubuntu", "ref"),
    [
        ("g2o", "g2o/core/sparse_optimizer.h", "20.04", "20201223_git"),
        ("g2o", "g2o/types/sba/vertex_se3_expmap.h", "20.04", "20230223_git"),
        ("g2o", "g2o/types/sba/types_six_dof_expmap.h", "20.04", "20201223_git"),
        ("g2o", "g2o/autodiff/autodiff.h", "22.04", "20230806_git"),
        ("g2o", "g2o/core/base_binary_edge.hpp", "22.04", "20201223_git"),
        ("g2o", "g2o/types/slam3d/edge_xyz_prior.h", "16.04", "20200410_git"),
        ("Pangolin", "pangolin/pangolin.h", "20.04", "v0.6"),
        ("Pangolin", "pangolin/windowing/window.h", "20.04", "v0.7"),
        ("Pangolin", "pangolin/handler/handler_enums.h", "22.04", "v0.6"),
        ("Pangolin", "pangolin/gl/glglut.h", "20.04", "v0.5"),
        ("Pangolin 0.8", "pangolin/pangolin.h", "20.04", "v0.8"),
    ],
)
def test_the_release_has_the_header(tree: Tree, library: str, header: str, ubuntu: str, ref: str) -> None:
    code = f"#include <{header}>\nint main() {{}}\n"
    files = {"CMakeLists.txt": CPP.format(library), "a.cpp": code, "README.md": f"Tested on Ubuntu {ubuntu}\n"}
    assert built(tree(files)) == {library.partition(" ")[0].lower(): ref}


@pytest.mark.parametrize(
    ("distro", "header", "found"),
    [
        ("noetic", "g2o/core/sparse_optimizer.h", {}),
        ("noetic", "g2o/types/sba/vertex_se3_expmap.h", {"g2o": "20230223_git"}),  # ROS has that of 2020-05-03
        ("noetic", "g2o/types/slam3d/edge_xyz_prior.h", {}),
    ],
)
def test_the_release_of_ros_may_be_older(tree: Tree, distro: str, header: str, found: dict[str, str]) -> None:
    files = {"CMakeLists.txt": ROS.format("g2o"), "package.xml": PACKAGE, "README.md": f"For ROS {distro}\n"}
    decision = tree({**files, "a.cpp": f"#include <{header}>\nint main() {{}}\n"})
    assert decision.ros_distro == distro
    assert built(decision) == found
    assert (f"ros-{distro}-libg2o" in decision.apt_guessed) is not bool(found)


@pytest.mark.parametrize(
    ("guard", "ref"),
    [
        ("__has_include(<g2o/types/sba/vertex_cam.h>)", "20201223_git"),
        ("__has_include(<spdlog/sinks/rotating_file_sink.h>)", "20230223_git"),
        ("__has_include(HEADER)", "20201223_git"),
    ],
)
def test_code_that_asks_for_the_header_of_another_library_needs_this_one(tree: Tree, guard: str, ref: str) -> None:
    code = f"#if {guard}\n#define A\n#endif\n#include <g2o/types/sba/vertex_se3_expmap.h>\n"
    files = {"CMakeLists.txt": CPP.format("g2o"), "a.cpp": code, "README.md": "Tested on Ubuntu 20.04\n"}
    assert built(tree(files)) == {"g2o": ref}


@pytest.mark.parametrize(
    ("header", "library"),
    [
        ("opencv2/core.hpp", "OpenCV"),
        ("ceres/manifold.h", "Ceres"),
        ("Eigen/Core", "Eigen3"),
        ("cv_bridge/cv_bridge.hpp", "ROS 2: vision_opencv"),
        ("filesystem", None),
    ],
)
def test_a_header_tells_its_library(header: str, library: str | None) -> None:
    found = set(asked_for(f"#if __has_include(<{header}>)\n"))
    assert "GCC" not in found
    assert library is None or library in found
    assert len(found) < 5
