"""A release of a library that a page lists among its requirements tells the Ubuntu where nobody names one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nadd_executable(a a.cpp)\n"
CODE = {"CMakeLists.txt": CMAKE, "a.cpp": "#include <opencv2/opencv.hpp>\nint main() {}\n"}


@pytest.mark.parametrize(
    ("page", "ubuntu"),
    [
        ("## Prerequisites\n* Eigen 3\n* OpenCV3\n", "bionic"),
        ("## Requirements\n- [OpenCV](https://opencv.org) 3.x\n", "bionic"),
        ("## Dependencies\n- OpenCV 3.4.1\n", "bionic"),
        ("## Dependencies\n- OpenCV >= 3\n- PCL 1.8\n", "jammy"),
        ("## Dependencies\n- OpenCV 3 or newer\n", "jammy"),
        ("## Dependencies\n- OpenCV 2.4.9\n", "xenial"),
        ("## Dependencies\n- OpenCV 2.4 or 3.4\n", "jammy"),
        ("## Dependencies\n- OpenCV 3 (optional)\n", "jammy"),
        ("## Dependencies\n- OpenCV 7\n", "jammy"),
        ("## Dependencies\n- OpenCV\n", "jammy"),
        ("## News\n* OpenCV3\n", "jammy"),
        ("## Dependencies\n* OpenCV3\n* Ubuntu 20.04\n", "focal"),
        ("## Dependencies\n* OpenCV 3\n* PCL 1.12\n", "jammy"),  # no Ubuntu has both
    ],
)
def test_the_ubuntu_of_a_listed_release(tree: Tree, page: str, ubuntu: str) -> None:
    assert tree({**CODE, "README.md": f"# Demo\n{page}"}).ubuntu == ubuntu


@pytest.mark.parametrize(
    ("code", "ubuntu"),
    [("void f() { cv::imread(a, CV_LOAD_IMAGE_COLOR); }\n", "bionic"), ("#include <opencv2/videoio.hpp>\n", "jammy")],
)
def test_what_the_code_shows_is_stronger(tree: Tree, code: str, ubuntu: str) -> None:
    page = "# Demo\n## Dependencies\n* OpenCV 2.4\n" if ubuntu == "jammy" else "# Demo\n## Dependencies\n* OpenCV 4\n"
    assert tree({**CODE, "a.cpp": code, "README.md": page}).ubuntu == ubuntu


@pytest.mark.parametrize(
    ("find", "ubuntu"),
    [
        ("find_package(DART 6.6 REQUIRED COMPONENTS gui)\n", "jammy"),  # bionic has no package of it
        ("find_package(DART REQUIRED)\n", "jammy"),
        ("find_package(DART)\n", "bionic"),
        ("find_package(Eigen3 REQUIRED)\n", "bionic"),
    ],
)
def test_an_ubuntu_without_a_package_that_cmake_requires_is_not_taken(tree: Tree, find: str, ubuntu: str) -> None:
    files = {**CODE, "CMakeLists.txt": CMAKE + find, "README.md": "# Demo\n## Dependencies\n- OpenCV 3.2.0\n"}
    assert tree(files).ubuntu == ubuntu


PPA = "```bash\nsudo add-apt-repository ppa:lab/dart\nsudo apt install {}\n```\n"


@pytest.mark.parametrize(
    ("page", "files", "ubuntu"),
    [
        ("", {}, "jammy"),
        (PPA.format("libdart6-all-dev"), {}, "bionic"),
        (PPA.format("libdartmouth-dev"), {}, "jammy"),
        ("", {"lib/dart/CMakeLists.txt": "project(dart CXX)\nadd_library(dart a.cpp)\n"}, "bionic"),
        ("", {"FETCH": "FetchContent_Declare(dart GIT_REPOSITORY https://github.com/lab/dart)\n"}, "bionic"),
    ],
)
def test_but_where_the_page_or_the_tree_brings_it(tree: Tree, page: str, files: dict[str, str], ubuntu: str) -> None:
    cmake = f"{CMAKE}{files.get('FETCH', '')}find_package(DART REQUIRED)\n"
    said = f"# Demo for Ubuntu 18.04\n## Dependencies\n- OpenCV 3.2.0\n{page}"
    other = {path: text for path, text in files.items() if path != "FETCH"}
    assert tree({**CODE, **other, "CMakeLists.txt": cmake, "README.md": said}).ubuntu == ubuntu
