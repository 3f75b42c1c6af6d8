"""Tests of a CMake project are not compiled where they alone ask for what is not installed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TOP = "cmake_minimum_required(VERSION 3.16)\nproject(demo CXX)\ninclude(CTest)\nadd_executable(run run.cpp)\n"
BELOW = f"{TOP}if(BUILD_TESTING)\nadd_subdirectory(tests)\nendif()\n"
HERE = f"{TOP}if(BUILD_TESTING)\nfind_package(GTest REQUIRED)\nendif()\n"
ASKS = "find_package(GTest REQUIRED)\nadd_executable(try try.cpp)\nadd_test(try try)\n"
CODE = {"run.cpp": "int main() {}\n", "tests/try.cpp": "int main() {}\n"}


@pytest.mark.parametrize(
    ("files", "left_out"),
    [
        ({"CMakeLists.txt": BELOW, "tests/CMakeLists.txt": ASKS}, True),
        ({"CMakeLists.txt": HERE}, True),
        ({"CMakeLists.txt": BELOW, "tests/CMakeLists.txt": ASKS.replace("GTest", "Threads")}, False),
        ({"CMakeLists.txt": BELOW, "tests/CMakeLists.txt": ASKS, "apt.txt": "libgtest-dev\n"}, False),
        (
            {
                "CMakeLists.txt": BELOW,
                "tests/CMakeLists.txt": ASKS,
                "README.md": "```\ncmake -DBUILD_TESTING=ON ..\nmake\n```\n",
            },
            False,
        ),
        ({"CMakeLists.txt": TOP}, False),
    ],
    ids=["below", "guarded", "of-cmake", "installed", "asked-for", "none"],
)
def test_tests_that_lack_a_package_are_not_compiled(tree: Tree, files: dict[str, str], left_out: bool) -> None:
    decision = tree({**CODE, **files})
    assert ("-DBUILD_TESTING=OFF" in decision.cmake_options) is left_out
    assert any(warning.message.startswith("only the tests ask for GTest") for warning in decision.warnings) is left_out
    assert decision.ctest is ("tests/CMakeLists.txt" in files and not left_out)


def test_tests_are_compiled_where_their_library_is_there_by_another_name(tree: Tree) -> None:
    asks = ASKS.replace("GTest", "YamlCpp")
    decision = tree({**CODE, "CMakeLists.txt": BELOW, "tests/CMakeLists.txt": asks, "apt.txt": "libyaml-cpp-dev\n"})
    assert "-DBUILD_TESTING=OFF" not in decision.cmake_options


OPTION = 'option(DEMO_TESTS "Build tests" ON)\n'
GUARDED = f"{TOP}{OPTION}if(DEMO_TESTS)\nadd_subdirectory(tests)\nendif()\n"


@pytest.mark.parametrize(
    ("files", "options", "installed"),
    [
        ({"CMakeLists.txt": GUARDED}, {"-DDEMO_TESTS=OFF"}, False),
        ({"CMakeLists.txt": GUARDED.replace(" ON)", " OFF)")}, set(), False),
        ({"CMakeLists.txt": f"{TOP}add_subdirectory(tests)\n"}, set(), True),
        ({"CMakeLists.txt": TOP}, set(), False),
        ({"CMakeLists.txt": f"{TOP}add_subdirectory(tests)\n", "tests/CMakeLists.txt": ""}, set(), False),
        (
            {"CMakeLists.txt": GUARDED, "README.md": "```\ncmake -DDEMO_TESTS=ON ..\nmake\n```\n"},
            {"-DDEMO_TESTS=ON"},
            True,
        ),
        (
            {"CMakeLists.txt": GUARDED, "README.md": "```\ncmake -DDEMO_TESTS=OFF ..\nmake\n```\n"},
            {"-DDEMO_TESTS=OFF"},
            False,
        ),
        (
            {
                "CMakeLists.txt": f"{TOP}{OPTION}add_subdirectory(tests)\n",
                "tests/CMakeLists.txt": "if(DEMO_TESTS)\nadd_subdirectory(unit)\nendif()\n",
                "tests/unit/CMakeLists.txt": ASKS,
            },
            {"-DDEMO_TESTS=OFF"},
            False,
        ),
    ],
    ids=["on", "off", "always", "not-added", "asks-nothing", "asked-for", "refused", "two-folders-below"],
)
def test_an_option_of_the_project_leaves_its_tests_out(
    tree: Tree, files: dict[str, str], options: set[str], installed: bool
) -> None:
    """The packages of tests that nothing leaves out are installed: CMake stops without them."""
    decision = tree({**CODE, "tests/CMakeLists.txt": ASKS, **files})
    assert {option for option in decision.cmake_options if "TEST" in option} == options
    assert ("libgtest-dev" in decision.apt) is installed


def test_a_program_of_a_folder_that_an_option_adds_depends_on_the_option(tree: Tree) -> None:
    top = f'{TOP}option(DEMO_EXAMPLES "" OFF)\nif(DEMO_EXAMPLES)\nadd_subdirectory(extra)\nendif()\n'
    below = "find_package(OpenCV REQUIRED)\nadd_executable(show show.cpp)\n"
    files = {"CMakeLists.txt": top, "extra/CMakeLists.txt": below, "extra/show.cpp": "int main() {}\n"}
    decision = tree({**CODE, **files, "README.md": "# Usage\n```\n./show\n./run\n```\n"})
    assert decision.command == ("show",)
    assert "-DDEMO_EXAMPLES=ON" in decision.cmake_options


XML = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
ROS = "cmake_minimum_required(VERSION 2.8.3)\nproject(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"


@pytest.mark.parametrize(
    ("distro", "adds", "built", "installed"),
    [
        ("Kinetic", "add_subdirectory(src/tests)\n", True, False),
        ("Noetic", "add_subdirectory(src/tests)\n", False, True),
        ("Kinetic", "if(CATKIN_ENABLE_TESTING)\nadd_subdirectory(src/tests)\nendif()\n", False, False),
        ("Kinetic", "option(TESTS OFF)\nif(TESTS)\nadd_subdirectory(src/tests)\nendif()\n", False, False),
        ("Kinetic", "", False, False),
    ],
)
def test_what_the_tests_of_a_package_always_require_is_there(
    tree: Tree, distro: str, adds: str, built: bool, installed: bool
) -> None:
    files = {"README.md": f"ROS {distro}\n", "package.xml": XML, "CMakeLists.txt": ROS + adds}
    decision = tree({**files, "src/tests/CMakeLists.txt": ASKS, "src/tests/try.cpp": "int main() {}\n"})
    assert ("googletest" in [source.name for source in decision.source]) is built
    assert ("libgtest-dev" in decision.apt) is installed


ARM_XML = "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
ARM_CMAKE = "project(arm)\nfind_package(ament_cmake REQUIRED)\nif(BUILD_TESTING)\nfind_package({} REQUIRED)\nendif()\n"


@pytest.mark.parametrize(
    ("asked", "files", "left_out"),
    [
        ("code_style", {}, True),
        ("ament_lint_auto", {}, False),
        ("GTest", {}, False),
        (
            "style",
            {"style/package.xml": ARM_XML.replace("arm", "style"), "style/CMakeLists.txt": "project(style)\n"},
            False,
        ),
        ("code_style", {"README.md": "```\ncolcon build --cmake-args -DBUILD_TESTING=ON\n```\n"}, False),
        ("code_style", {"arm/COLCON_IGNORE": "", "b/package.xml": ARM_XML, "b/CMakeLists.txt": "project(b)\n"}, False),
    ],
)
def test_tests_of_packages_that_ask_for_what_nobody_has(
    tree: Tree, asked: str, files: dict[str, str], left_out: bool
) -> None:
    decision = tree({"arm/package.xml": ARM_XML, "arm/CMakeLists.txt": ARM_CMAKE.format(asked), **files})
    assert decision.build_tool == "colcon"
    assert ("-DBUILD_TESTING=OFF" in decision.cmake_options) is left_out
    assert any(f"only the tests ask for {asked}" in each.message for each in decision.warnings) is left_out


@pytest.mark.parametrize("release", ["18.04", "22.04"])
def test_what_would_be_compiled_for_the_tests_alone_leaves_them_out(tree: Tree, release: str) -> None:
    """Ubuntu 18.04 has googletest's sources alone, so that a table tells how it is built."""
    files = {"CMakeLists.txt": HERE.replace("GTest ", "GTest CONFIG "), "README.md": f"Made on Ubuntu {release}.\n"}
    decision = tree({**CODE, **files})
    assert decision.base_image == f"ubuntu:{release}"
    assert "-DBUILD_TESTING=OFF" in decision.cmake_options


def test_what_is_compiled_anyway_leaves_no_tests_out(tree: Tree) -> None:
    files = {"CMakeLists.txt": f"{HERE}find_package(GTest REQUIRED)\n", "README.md": "Made on Ubuntu 18.04.\n"}
    decision = tree({**CODE, **files})
    assert [source.name for source in decision.source] == ["googletest"]
    assert "-DBUILD_TESTING=OFF" not in decision.cmake_options
