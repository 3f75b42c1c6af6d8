"""What a page fetches beside a library that it builds, and names in an option of that."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = {"CMakeLists.txt": "project(demo)\nfind_package(grasplib REQUIRED)\nadd_executable(demo main.cpp)\n"}
LIBRARY = "git clone https://github.com/lab/grasplib.git\ncd grasplib && git checkout v2.1 && cd ..\n"
BUILT = "cd grasplib\nmkdir build && cd build\ncmake -DMORE={more} -DGUI=OFF ..\nmake\nsudo make install\n"
ARCHIVE = "wget https://github.com/lab/grasplib_more/archive/v2.1.tar.gz\ntar xzf v2.1.tar.gz\n"
CLONE = "git clone -b v2.1 https://github.com/lab/grasplib_more.git\n"
STEPS = (
    "git clone https://github.com/lab/grasplib_more{end} ../grasplib_more"
    " && git -C ../grasplib_more -c advice.detachedHead=false checkout v2.1"
)


@pytest.mark.parametrize(
    ("fetched", "more", "options", "end"),
    [
        (ARCHIVE, "../../grasplib_more-2.1/modules", "-DMORE=../../grasplib_more/modules -DGUI=OFF", ""),
        (CLONE, "../../grasplib_more/modules", "-DMORE=../../grasplib_more/modules -DGUI=OFF", ".git"),
        (CLONE, "/opt/grasplib_more", "-DMORE=../../grasplib_more -DGUI=OFF", ".git"),
        (CLONE, "../../modules", "-DMORE=../../modules -DGUI=OFF", None),
        ("", "../../grasplib_more/modules", "-DMORE=../../grasplib_more/modules -DGUI=OFF", None),
    ],
)
def test_what_an_option_names_is_fetched_beside_the_library(
    tree: Tree, fetched: str, more: str, options: str, end: str | None
) -> None:
    page = f"```\n{LIBRARY}{fetched}{BUILT.format(more=more)}```\n"
    (source,) = (each for each in tree({**CMAKE, "README.md": page}).source if each.name == "grasplib")
    assert source.cmake_options == options
    assert source.prepare == ("" if end is None else STEPS.format(end=end))


BUILDS = "git clone https://github.com/opencv/opencv && cd opencv && git checkout 3.4.2 && mkdir build && cd build"
OF_PAGE = "git clone -b 3.4.6 https://github.com/opencv/opencv.git\nmkdir opencv/build && cd opencv/build\n"


@pytest.mark.parametrize(
    ("page", "built"),
    [
        ("", ("3.4.2", True)),
        (f"```\n{OF_PAGE}cmake ..\nsudo make install\n```\n", ("3.4.6", False)),
    ],
)
def test_a_library_of_the_table_is_built_as_the_authors_image_has_it(
    tree: Tree, page: str, built: tuple[str, bool]
) -> None:
    files = {
        "CMakeLists.txt": "project(demo)\nfind_package(OpenCV 3 REQUIRED)\nadd_executable(demo main.cpp)\n",
        "Dockerfile": f"FROM ubuntu:16.04\nRUN {BUILDS} && cmake -DWITH_TBB=OFF .. && make && make install\n",
        "README.md": page,
    }
    (source,) = (each for each in tree(files).source if each.name == "opencv")
    assert (source.ref, "-DWITH_TBB=OFF" in source.cmake_options) == built


@pytest.mark.parametrize(
    ("more", "cloned"),
    [("../../opencv_contrib/modules", []), ("../../modules", ["opencv_contrib"])],
)
def test_modules_of_a_library_are_no_package_of_the_workspace(tree: Tree, more: str, cloned: list[str]) -> None:
    xml = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>OpenCV</depend></package>"
    page = "git clone -b 4.5.0 https://github.com/opencv/opencv\n"
    page += "git clone -b 4.5.0 https://github.com/opencv/opencv_contrib\n"
    page += f"cd opencv\nmkdir build && cd build\ncmake -DMORE={more} ..\nmake\nsudo make install\n"
    cmake = "project(demo)\nfind_package(catkin REQUIRED)\nfind_package(OpenCV REQUIRED)\n"
    decision = tree({"package.xml": xml, "CMakeLists.txt": cmake, "README.md": f"ROS Noetic\n```\n{page}```\n"})
    assert sorted(source.name for source in decision.source) == cloned


OPTIONS = "-DWITH_CUDA=ON -D CUDA_ARCH_BIN=8.6 -DWITH_TBB=ON -DBUILD_opencv_cudacodec=OFF"


@pytest.mark.parametrize(
    ("more", "kept"),
    [
        ({}, False),
        ({"kernel.cu": "__global__ void run() {}\n", "train.py": "import torch\n"}, True),
    ],
    ids=["without", "with"],
)
def test_options_for_cuda_need_it_in_the_image(tree: Tree, more: dict[str, str], kept: bool) -> None:
    page = f"```\n{OF_PAGE}cmake {OPTIONS} ..\nsudo make install\n```\n"
    languages = " LANGUAGES CXX CUDA" if kept else ""
    cmake = f"project(demo{languages})\nfind_package(OpenCV 3 REQUIRED)\nadd_executable(demo main.cpp)\n"
    files = {"CMakeLists.txt": f"cmake_minimum_required(VERSION 3.10)\n{cmake}", "main.cpp": "int main() {}\n"}
    (source,) = (each for each in tree({**files, **more, "README.md": page}).source if each.name == "opencv")
    words = source.cmake_options.split()
    assert {"-DWITH_TBB=ON", "-DBUILD_opencv_cudacodec=OFF"} <= {*words}
    assert ("-DWITH_CUDA=ON" in words, "-DCUDA_ARCH_BIN=8.6" in words) == (kept, kept)
