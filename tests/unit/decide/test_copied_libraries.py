"""Of libraries that were copied whole into the tree, only what its own code reaches is compiled."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BASE = {
    "README.md": "ROS Noetic\n",
    "package.xml": (
        "<package format='2'><name>shapes</name><version>0.1.0</version><description>d</description>"
        "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
        "<buildtool_depend>catkin</buildtool_depend></package>"
    ),
    "CMakeLists.txt": (
        "project(shapes)\nfind_package(catkin REQUIRED)\ninclude_directories(include)\n"
        "add_library(shapes src/shape.cpp)\n"
    ),
    "src/shape.cpp": '#include "shapes/shape.hpp"\n',
    "include/shapes/shape.hpp": "#pragma once\n",
    "include/igl/AABB.h": '#include "normal.h"\n',
    "include/igl/normal.h": "#pragma once\n",
    "include/igl/glfw/viewer.h": '#include <GLFW/glfw3.h>\n#include "plugin.cpp"\n',
    "include/igl/glfw/plugin.cpp": "#include <backends/imgui_glfw.h>\n",
    "include/igl/xml/write.h": "#include <tinyxml2.h>\n",
    "include/igl/plot.py": "import scipy\n",
}


def needed(decision: Decision) -> set[str]:
    return {*decision.apt_guessed, *decision.apt} & {"libglfw3-dev", "libtinyxml2-dev", "python3-scipy"}


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({}, set()),
        ({"src/shape.cpp": "#include <igl/AABB.h>\n"}, set()),
        ({"src/shape.cpp": "#include <igl/glfw/viewer.h>\n"}, {"libglfw3-dev"}),
        ({"include/shapes/shape.hpp": "#include <igl/glfw/viewer.h>\n"}, {"libglfw3-dev"}),
        (
            {"src/shape.cpp": "#include <igl/AABB.h>\n", "include/igl/normal.h": '#include "xml/write.h"\n'},
            {"libtinyxml2-dev"},
        ),
        ({"src/shape.cpp": "#include <igl/glfw/../xml/write.h>\n"}, {"libtinyxml2-dev"}),
        ({"src/shape.cpp": '#include "write.h"\n'}, set()),
        ({"src/shape.cpp": "// #include <igl/xml/write.h>\n"}, set()),
        ({"tools/plot.py": "#!/usr/bin/env python3\nimport scipy\n"}, {"python3-scipy"}),
    ],
)
def test_what_is_reached_counts(tree: Tree, files: dict[str, str], found: set[str]) -> None:
    assert needed(tree({**BASE, **files})) == found


@pytest.mark.parametrize(("included", "told"), [("igl/AABB.h", False), ("igl/glfw/viewer.h", True)])
def test_of_the_rest_nothing_is_told(tree: Tree, included: str, *, told: bool) -> None:
    cmake = BASE["CMakeLists.txt"] + "file(GLOB libraries lib/*.a)\n"  # whatever a glob takes is no source of this
    decision = tree({**BASE, "CMakeLists.txt": cmake, "src/shape.cpp": f"#include <{included}>\n"})
    assert any("backends" in w.message for w in decision.warnings) == told


def test_a_folder_of_that_name_elsewhere_is_the_tree_s_own(tree: Tree) -> None:
    assert needed(tree({**BASE, "cereal/plot.py": "import scipy\n"})) == {"python3-scipy"}


@pytest.mark.parametrize(("holds", "found"), [("Eigen/Core", set()), ("shapes/Core", {"libtinyxml2-dev"})])
def test_a_folder_of_that_name_that_does_not_hold_the_library_is_the_tree_s_own(
    tree: Tree, holds: str, found: set[str]
) -> None:
    files = {f"include/eigen/{holds}": "#pragma once\n", "include/eigen/save.h": "#include <tinyxml2.h>\n"}
    assert needed(tree({**BASE, "src/shape.cpp": "#include <shapes/shape.hpp>\n", **files})) == found


def test_the_library_itself_is_no_copy(tree: Tree) -> None:
    cmake = BASE["CMakeLists.txt"].replace("project(shapes)", "project(libigl)")
    assert "libtinyxml2-dev" in needed(tree({**BASE, "CMakeLists.txt": cmake}))


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({}, set()),
        ({"include/shapes/shape.hpp": '#include "impl/part.cpp"\n'}, {"libtinyxml2-dev"}),
        (
            {"CMakeLists.txt": BASE["CMakeLists.txt"].replace("src/shape.cpp", "include/shapes/impl/part.cpp")},
            {"libtinyxml2-dev"},
        ),
        (
            {"CMakeLists.txt": BASE["CMakeLists.txt"] + "file(GLOB parts include/shapes/impl/*.cpp)\n"},
            {"libtinyxml2-dev"},
        ),
    ],
)
def test_a_source_among_headers_is_one_where_cmake_or_a_header_takes_it(
    tree: Tree, files: dict[str, str], found: set[str]
) -> None:
    assert needed(tree({**BASE, "include/shapes/impl/part.cpp": "#include <tinyxml2.h>\n", **files})) == found
