"""A library that the tree's script compiles and that a package of the tree wraps under its name is built first."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SCRIPT = """\
#!/bin/bash
git clone https://github.com/lab/{name} -b v2
cd {name}
sudo apt-get -y install g++-8 libtbb2
mkdir -p build && cd build
cmake -D CMAKE_CXX_COMPILER=g++-8 ..
make
sudo make install
sudo apt-get -y install zip
git clone https://github.com/lab/other.git
sudo apt-get -y install libpng-dev
"""
MADE = """\
cmake_minimum_required(VERSION 3.5)
project(acmeface)
find_package(ament_cmake REQUIRED)
find_library(LD Landmarks{where})
add_executable(node src/node.cpp)
target_link_libraries(node ${{LD}})
ament_package()
"""
MANIFEST = (
    "<package format='3'><name>acmeface</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)


def tree_with(include: str, where: str = " PATH_SUFFIXES lib acmeface", name: str = "AcmeFace") -> dict[str, str]:
    return {
        "ros2_acmeface/package.xml": MANIFEST,
        "ros2_acmeface/CMakeLists.txt": MADE.format(where=where),
        "ros2_acmeface/src/node.cpp": f"#include <{include}>\nint main() {{}}\n",
        "ros2_acmeface/include/acmeface/own.h": "",
        "scripts/install.sh": SCRIPT.format(name=name),
        "README.md": "ROS 2 Humble, see scripts/install.sh\n",
    }


@pytest.mark.parametrize(
    ("include", "name", "built"),
    [
        ("AcmeFace/Visual.h", "AcmeFace", ["AcmeFace"]),
        ("acmeface/visual.h", "AcmeFace", ["AcmeFace"]),
        ("acmeface/own.h", "AcmeFace", []),  # the package's own
        ("AcmeFace/Visual.h", "ros2_acmeface", []),
    ],
)
def test_a_library_of_the_name_of_a_package(tree: Tree, include: str, name: str, built: list[str]) -> None:
    decision = tree(tree_with(include, name=name))
    assert [source.name for source in decision.source] == built


def test_what_the_script_installs_up_to_its_next_clone_is_offered(tree: Tree) -> None:
    (source,) = tree(tree_with("AcmeFace/Visual.h")).source
    assert (source.ref, source.cmake_options) == ("v2", "-DCMAKE_CXX_COMPILER=g++-8")
    assert source.offered == ("g++-8", "libtbb2", "zip")


@pytest.mark.parametrize(("where", "told"), [(" PATH_SUFFIXES lib acmeface", False), ("", True)])
def test_a_search_in_the_folder_of_a_library_that_is_built_is_not_told(tree: Tree, where: str, told: bool) -> None:
    decision = tree(tree_with("AcmeFace/Visual.h", where))
    assert any("Landmarks, which find_library looks for" in each.message for each in decision.warnings) is told
