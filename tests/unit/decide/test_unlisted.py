"""Signs of versions are taken from the sources that something compiles."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
OLD = "#include <opencv/cv.h>\n"
PAGE = "Tested on Ubuntu 22.04.\n"


def plain(targets: str, *, old: str = "src/old.cpp") -> dict[str, str]:
    cmake = f"cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(OpenCV REQUIRED)\n{targets}"
    return {"CMakeLists.txt": cmake, "README.md": PAGE, "src/a.cpp": "int main() {}\n", old: OLD}


@pytest.mark.parametrize(
    "targets",
    [
        "add_executable(a src/a.cpp)\n",
        "list(APPEND SOURCES\n  src/a.cpp)\nadd_library(a ${SOURCES})\n",
        "set(SOURCES src/a.cpp)  # src/old.cpp\nadd_library(a ${SOURCES})\n",
    ],
)
def test_a_source_that_no_list_names_is_no_sign(tree: Tree, targets: str) -> None:
    assert tree(plain(targets)).ubuntu == "jammy"


@pytest.mark.parametrize(
    "targets",
    [
        "",
        "add_executable(a src/a.cpp src/old.cpp)\n",
        "list(APPEND SOURCES src/old.cpp)\nadd_library(a src/a.cpp ${SOURCES})\n",
        "file(GLOB SOURCES src/*.cpp)\nadd_executable(a ${SOURCES})\nadd_executable(b src/a.cpp)\n",
        "aux_source_directory(src SOURCES)\nadd_library(a ${SOURCES})\nadd_executable(b src/a.cpp)\n",
        "foreach(name a old)\nadd_executable(${name} src/${name}.cpp)\nendforeach()\n",
        "set(NAMES old)\nadd_library(c src/a.cpp)\nadd_more(${NAMES})\n",
    ],
)
def test_one_that_a_list_may_have_is_one(tree: Tree, targets: str) -> None:
    assert tree(plain(targets)).ubuntu == "bionic"


def test_lists_elsewhere_and_includes_of_sources_count(tree: Tree) -> None:
    files = plain("add_executable(a src/a.cpp)\ninclude(more.cmake)\n")
    assert tree({**files, "more.cmake": "set(MORE src/old.cpp)\n"}).ubuntu == "bionic"
    files["src/a.cpp"] = '#include "old.cpp"\n'
    assert tree({**files, "more.cmake": ""}).ubuntu == "bionic"


XML = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
ROS = "find_package(catkin REQUIRED)\ncatkin_package()\n"


@pytest.mark.parametrize(
    ("other", "release"),
    [
        ("add_executable(b src/old.cpp)\n", "noetic"),  # another program, which catkin does not compile
        ("add_executable(b ../node/src/old.cpp)\n", "melodic"),
        ("", "noetic"),
    ],
)
def test_a_list_names_the_file_of_its_own_folder(tree: Tree, other: str, release: str) -> None:
    files = {f"node/{path}": text for path, text in plain(f"{ROS}add_executable(a src/a.cpp)\n").items()}
    files |= {f"other/{path}": text for path, text in plain(other).items()}
    page = "Works with ROS Melodic and ROS Noetic.\n"
    assert tree({**files, "node/package.xml": XML, "README.md": page}).ros_distro == release


@pytest.mark.parametrize(
    ("text", "ubuntu"),
    [
        ("/* the old one:\n  show(CV_WINDOW_NORMAL);\n*/\nint main() {}\n", "jammy"),
        ("/* the new one */\nvoid run() {\n  show(CV_WINDOW_NORMAL);\n}\n", "bionic"),
    ],
)
def test_a_name_in_a_comment_is_no_sign(tree: Tree, text: str, ubuntu: str) -> None:
    assert tree({**plain("add_executable(a src/a.cpp)\n", old="src/a.h"), "src/a.cpp": text}).ubuntu == ubuntu
