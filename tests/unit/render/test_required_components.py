"""The script that finds what CMake of cloned packages requires of ROS beyond their package.xml."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.knowledge.libraries import cmake_packages
from roslab.render import image_scripts
from trees import tree_of

pytestmark = pytest.mark.usefixtures("scripts_on_path")
SCRIPT = Path(image_scripts.__path__[0]) / "required-components.sh"


@pytest.mark.parametrize(
    ("cmake", "packages"),
    [
        ("find_package(catkin REQUIRED COMPONENTS roscpp pcl_ros mine)", ["ros-noetic-pcl-ros"]),
        ("find_package(catkin COMPONENTS\n roscpp\n pcl_ros # or\n tf2)\n", ["ros-noetic-pcl-ros", "ros-noetic-tf2"]),
        ("FIND_PACKAGE( catkin COMPONENTS pcl_ros )", ["ros-noetic-pcl-ros"]),
        ("# find_package(catkin REQUIRED COMPONENTS pcl_ros)\nfind_package(catkin REQUIRED)", []),
        ("find_package(rclcpp REQUIRED)\nfind_package(tf2)", ["ros-noetic-rclcpp"]),
        ("find_package(nowhere REQUIRED)", ["ros-noetic-nowhere"]),
        ("find_package(catkin REQUIRED COMPONENTS ${NEEDED} roscpp)", []),
        ("find_package(OpenCV 3 REQUIRED)\nfind_package(OpenMP REQUIRED)", ["libopencv-dev"]),
        ("find_package(SuiteSparse\n  COMPONENTS core\n REQUIRED)", ["libsuitesparse-dev"]),
        ("find_package(OpenCV)\nfind_package(Mine REQUIRED)\nfind_package(made REQUIRED)", []),
        ("find_package(Nowhere REQUIRED)\nfind_package(Ceres REQUIRED)", []),
        ("find_package(G2O REQUIRED)", ["ros-noetic-libg2o"]),
        ("find_package(octomap REQUIRED)", []),
        ('option(SHOW "Draw (slow)" OFF)\nif(SHOW)\nfind_package(OpenCV REQUIRED)\nendif()', []),
        ("option(SHOW)\nif(NOT SHOW)\nelse()\nif(A)\nfind_package(OpenCV REQUIRED)\nendif()\nendif()", []),
        (
            "option(SHOW s ON)\nif(SHOW)\nfind_package(OpenCV REQUIRED)\nelse()\nfind_package(PCL REQUIRED)\nendif()",
            ["libopencv-dev"],
        ),
        (
            "if(WIN32)\nfind_package(PCL REQUIRED)\nelseif(A AND (B OR C))\nfind_package(OpenCV REQUIRED)\nendif()",
            ["libopencv-dev"],
        ),
        ("if(A)\nset(SHOW OFF)\nendif()\nif(SHOW)\nfind_package(OpenCV REQUIRED)\nendif()", ["libopencv-dev"]),
        (
            'ExternalProject_Add(a UPDATE_COMMAND ""\n CONFIGURE_COMMAND cd ../a && ./autogen.sh && ./configure --a)',
            ["autoconf", "automake", "libtool", "pkg-config"],
        ),
        ('ExternalProject_Add(a PATCH_COMMAND bash -c "cd a; patch -p1 < b.patch")', ["patch"]),
        (
            "ExternalProject_Add(a SVN_REPOSITORY http://a.org/a)\nif(WIN32)\nexecute_process(COMMAND wget a)\nendif()",
            ["subversion"],
        ),
        (
            "find_program(BISON bison)\nadd_custom_command(OUTPUT a COMMAND ${CMAKE_COMMAND} -E env A=b ${BISON} a.y)",
            ["bison"],
        ),
        ("add_custom_target(patch DEPENDS unzip)\nexecute_process(COMMAND git log curl)\n# COMMAND wget a", []),
        ("exec_program(hg ARGS identify)", ["mercurial"]),
        ("project(mine)\n", []),
    ],
)
def test_what_neither_ros_nor_the_workspace_has(tmp_path: Path, cmake: str, packages: list[str]) -> None:
    for path in (
        "ros/noetic/share/roscpp",
        "ros/noetic/share/octomap",
        "ws/mine",
        "ws/made",
        "local/lib/cmake",
        "table",
    ):
        (tmp_path / path).mkdir(parents=True)
    (tmp_path / "ws/mine/package.xml").write_text("<package>\n  <name>mine</name>\n</package>\n")
    (tmp_path / "ws/mine/CMakeLists.txt").write_text(cmake)
    (tmp_path / "ws/made/CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.5)\nproject( Made CXX)\n")
    (tmp_path / "ws/hidden/inner").mkdir(parents=True)
    (tmp_path / "ws/hidden/CATKIN_IGNORE").touch()
    (tmp_path / "ws/hidden/inner/CMakeLists.txt").write_text("find_package(Qt5 REQUIRED)\n")
    (tmp_path / "ws/CMakeLists.txt").symlink_to("/opt/ros/none/share/catkin/cmake/toplevel.cmake")
    (tmp_path / "local/lib/cmake/CeresConfig.cmake").touch()
    (tmp_path / "table/cmake-focal.txt").write_text(cmake_packages("focal"))
    text = SCRIPT.read_text().replace("/usr/local/share/roslab", f"{tmp_path}/table")
    script = tmp_path / "script"
    script.write_text(text.replace("/opt/ros/", f"{tmp_path}/ros/").replace("/usr/local/lib", f"{tmp_path}/local/lib"))
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin/apt-cache").write_text('#!/bin/bash\n[[ "$2" = ros-noetic-@(pcl-ros|tf2|rclcpp|libg2o) ]]\n')
    (tmp_path / "bin/apt-cache").chmod(0o755)
    ran = subprocess.run(
        ["bash", script, tmp_path / "ws"],
        env=os.environ | {"ROS_DISTRO": "noetic", "PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert ran.stdout.split() == packages


def test_without_ros_there_is_nothing_to_ask(tmp_path: Path) -> None:
    ran = subprocess.run(
        ["bash", SCRIPT, tmp_path], env=os.environ | {"ROS_DISTRO": "none"}, capture_output=True, text=True, check=True
    )
    assert ran.stdout == ""


@pytest.mark.parametrize(
    ("files", "names"),
    [
        ({"CMakeLists.txt": "include(needs.cmake)", "needs.cmake": "find_package(GDAL REQUIRED)"}, ["GDAL"]),
        ({"CMakeLists.txt": "include(needs)", "cmake/needs.cmake": "find_package(GDAL REQUIRED)"}, ["GDAL"]),
        (
            {
                "CMakeLists.txt": "include(${CMAKE_CURRENT_LIST_DIR}/a/b.cmake)",
                "a/b.cmake": "find_package(g2o REQUIRED)",
            },
            ["g2o"],
        ),
        (
            {"CMakeLists.txt": "include(${PROJECT_SOURCE_DIR}/a.cmake)", "a.cmake": "find_package(Qt5 REQUIRED)"},
            ["Qt5"],
        ),
        ({"CMakeLists.txt": "if(WIN32)\ninclude(a.cmake)\nendif()", "a.cmake": "find_package(Qt5 REQUIRED)"}, []),
        ({"CMakeLists.txt": "# include(a.cmake)\ninclude(CTest)", "a.cmake": "find_package(Qt5 REQUIRED)"}, []),
        ({"CMakeLists.txt": "include(a.cmake)", "a.cmake": "include(a.cmake)\nfind_package(Qt5)"}, []),
        # Each folder's own file is asked for by itself
        ({"CMakeLists.txt": "add_subdirectory(b)", "b/CMakeLists.txt": "find_package(Qt5 REQUIRED)"}, []),
    ],
)
def test_what_files_that_are_included_require(tmp_path: Path, files: dict[str, str], names: list[str]) -> None:
    tree_of(tmp_path, files)
    command = ["required-by-cmake", str(tmp_path / "CMakeLists.txt")]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.split() == names


def test_what_one_file_turns_off_another_one_requires(tmp_path: Path) -> None:
    include = "include(../needs.cmake)\n"
    files = {"a/CMakeLists.txt": f"option(A off OFF)\nif(A)\n{include}endif()\n", "b/CMakeLists.txt": include}
    tree_of(tmp_path, {**files, "needs.cmake": "find_package(GDAL REQUIRED)\n"})
    command = ["required-by-cmake", *(str(tmp_path / name) for name in files)]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.split() == ["GDAL"]


ANOTHER_WAY = "find_package(OpenBLAS REQUIRED)\nif(Openblas_FOUND)\n{}else(Openblas_FOUND)\n"
ANOTHER_WAY += "find_package(LAPACK REQUIRED)\nendif()\n"
WARNS = "find_library(B openblas)\nif(NOT B)\nmessage(WARNING none)\nendif()\n"
STOPS = "find_library(B openblas)\nfind_package_handle_standard_args(OpenBLAS REQUIRED_VARS B)\n"


@pytest.mark.parametrize(
    ("cmake", "module", "names"),
    [
        (ANOTHER_WAY.format(""), WARNS, ["LAPACK"]),
        (ANOTHER_WAY.format("if(A)\nelse()\nendif()\n"), WARNS, ["LAPACK"]),
        (ANOTHER_WAY.format(""), STOPS, ["LAPACK", "OpenBLAS"]),
        (ANOTHER_WAY.format(""), None, ["LAPACK", "OpenBLAS"]),
        ("find_package(OpenBLAS REQUIRED)\nif(Openblas_FOUND)\nendif()\n", WARNS, ["OpenBLAS"]),
        ("find_package(OpenBLAS REQUIRED)\nif(OpenBLAS_FOUND)\nelse()\nset(A)\nendif()\n", WARNS, ["OpenBLAS"]),
        ("find_package(OpenBLAS REQUIRED)\nif(A)\nelse()\nfind_package(LAPACK)\nendif()\n", WARNS, ["OpenBLAS"]),
        ("find_package(${A} REQUIRED)\nif(A_FOUND)\nelse()\nendif()\n", WARNS, []),
    ],
)
def test_what_a_file_has_another_way_for(tmp_path: Path, cmake: str, module: str | None, names: list[str]) -> None:
    tree_of(tmp_path, {"CMakeLists.txt": cmake, **({"cmake/FindOpenBLAS.cmake": module} if module else {})})
    command = ["required-by-cmake", str(tmp_path / "CMakeLists.txt")]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.split() == names


@pytest.mark.parametrize(("first", "second"), [(WARNS, STOPS), (STOPS, WARNS)])
def test_of_two_modules_of_a_name_either_may_stop_it(tmp_path: Path, first: str, second: str) -> None:
    modules = {"a/FindOpenBLAS.cmake": first, "b/FindOpenBLAS.cmake": second}
    tree_of(tmp_path, {"CMakeLists.txt": ANOTHER_WAY.format(""), **modules})
    command = ["required-by-cmake", str(tmp_path / "CMakeLists.txt")]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.split() == ["LAPACK", "OpenBLAS"]
