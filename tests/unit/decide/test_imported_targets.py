"""An imported target that came with a later release asks for that release."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.system.names import Target
from roslab.decide.system.too_old import too_old
from roslab.evidence.dependency import Dependency

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = """cmake_minimum_required(VERSION 3.5)
project(demo)
find_package(catkin REQUIRED)
find_package({package} REQUIRED)
add_executable(demo a.cpp)
{link}
"""
LINK = "target_link_libraries(demo {})"


def ros1(distro: str, package: str, link: str, **others: str) -> dict[str, str]:
    own = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": CMAKE.format(package=package, link=link),
        "a.cpp": "int main() {}\n",
    }
    return {**own, "README.md": f"For ROS {distro}\n", **others}


def built(decision: Decision) -> list[tuple[str, str | None]]:
    return [(source.name, source.ref) for source in decision.source]


@pytest.mark.parametrize(
    ("distro", "package", "target", "found"),
    [
        ("noetic", "Ceres", "Ceres::ceres", [("ceres", "2.0.0")]),  # focal has 1.14
        ("noetic", "Ceres", "ceres", []),
        ("noetic", "yaml-cpp", "yaml-cpp::yaml-cpp", [("yaml-cpp", "0.8.0")]),  # focal has 0.6.2
        ("noetic", "yaml-cpp", "yaml-cpp", []),
        ("kinetic", "Eigen3", "Eigen3::Eigen", [("eigen3", "3.3.7")]),  # xenial has 3.2.92
        ("melodic", "Eigen3", "Eigen3::Eigen", []),
        ("melodic", "spdlog", "spdlog::spdlog_header_only", [("spdlog", "v1.9.2")]),  # bionic has 0.16
        ("melodic", "spdlog", "spdlog::spdlog", []),
        ("kinetic", "g2o", "g2o::types_sba", [("g2o", "20200410_git")]),  # ROS has that of 2016
        ("melodic", "g2o", "g2o::types_sba", []),  # ROS has that of 2018-03-25
    ],
)
def test_the_release_that_has_the_target_is_built(
    tree: Tree, distro: str, package: str, target: str, found: list[tuple[str, str]]
) -> None:
    decision = tree(ros1(distro, package, LINK.format(target)))
    assert decision.ros_distro == distro
    assert built(decision) == found
    assert not any("this Ubuntu" in warning.message for warning in decision.warnings)
    because = [reason.reason for reason in decision.reasons if found and reason.answer.startswith(found[0][0])]
    assert not found or any(f"the target {target}" in why for why in because), because


@pytest.mark.parametrize(
    ("link", "others"),
    [
        (f"if(TARGET Ceres::ceres)\n{LINK.format('Ceres::ceres')}\nendif()", {}),
        (f"add_library(Ceres::ceres ALIAS own)\n{LINK.format('Ceres::ceres')}", {}),
        (LINK.format("Ceres::ceres"), {"cmake/FindCeres.cmake": "add_library(${TARGET} INTERFACE IMPORTED)\n"}),
        (f"function(link)\n{LINK.format('Ceres::ceres')}\nendfunction()", {}),
    ],
)
def test_one_that_the_tree_makes_or_may_not_link_asks_for_nothing(
    tree: Tree, link: str, others: dict[str, str]
) -> None:
    assert built(tree(ros1("noetic", "Ceres", link, **others))) == []


@pytest.mark.parametrize(
    ("target", "said"), [("PCL::all", "PCL::all is linked, which came with"), ("", "CMake requires")]
)
def test_what_no_recipe_builds_is_told(target: str, said: str) -> None:
    asked = Dependency(
        namespace="cmake", name="PCL", strength="declared", file="CMakeLists.txt", line=4, version="1.14", target=target
    )
    here = Target(ros_distro="noetic", ubuntu="focal")
    (told,) = too_old(iter([("demo", asked)]), here, (), (), "catkin_make")
    assert told.message.startswith(
        f"{said} PCL 1.14, and this Ubuntu (focal) has 1.10.0: catkin_make will stop at demo"
    )


@pytest.mark.parametrize(
    ("target", "asked"),
    [
        ("Python3::NumPy", "cmake>=3.14,<4"),
        ("Boost::headers", "cmake>=3.15,<4"),
        ("GTest::gtest_main", "cmake>=3.20,<4"),
        ("protobuf::libprotobuf", None),  # since 3.9
        ("OpenAL::OpenAL", "cmake>=3.25,<4"),
        ("CUDA::nvml", "cmake>=3.17,<4"),
        ("GTest::Main", None),
        ("Boost::system", None),
    ],
)
def test_one_of_cmakes_own_modules_asks_for_a_newer_cmake(tree: Tree, target: str, asked: str | None) -> None:
    decision = tree(ros1("melodic", "Boost", LINK.format(target)))
    assert [each.text for each in decision.python.pip_guessed if each.key == "cmake"] == ([asked] if asked else [])


@pytest.mark.parametrize(
    ("distro", "package", "target", "said"),
    [
        ("noetic", "TBB", "TBB::tbb", ""),
        ("melodic", "TBB", "tbb", ""),
        ("noetic", "assimp", "assimp::assimp", "assimp::assimp is linked, which came with assimp 5.1"),
        ("noetic", "assimp", "assimp", ""),
    ],
)
def test_a_target_of_a_later_release_that_no_recipe_builds_is_told(
    tree: Tree, distro: str, package: str, target: str, said: str
) -> None:
    decision = tree(ros1(distro, package, LINK.format(target)))
    told = [warning.message for warning in decision.warnings if "this Ubuntu" in warning.message]
    assert [message[: len(said)] for message in told] == ([said] if said else [])


@pytest.mark.parametrize(("target", "distro"), [("TBB::tbb", "noetic"), ("tbb", "melodic")])
def test_the_distribution_is_the_nearest_whose_ubuntu_has_the_target(tree: Tree, target: str, distro: str) -> None:
    assert tree(ros1("melodic", "TBB", LINK.format(target))).ros_distro == distro


def test_what_a_module_of_the_tree_finds_is_not_told(tree: Tree) -> None:
    module = {"cmake/FindTBB.cmake": "add_library(TBB::tbb INTERFACE IMPORTED)\n"}
    decision = tree({**ros1("melodic", "TBB", LINK.format("TBB::tbb")), **module})
    assert decision.ros_distro == "melodic"
    assert not any("this Ubuntu" in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    ("words", "asked"),
    [
        ("GTest REQUIRED", ["cmake>=3.20,<4"]),
        ("GTest CONFIG REQUIRED", []),
        ("GTest\n  REQUIRED NO_MODULE", []),
        ("Boost CONFIG REQUIRED", ["cmake>=3.20,<4"]),
    ],
)
def test_a_library_that_is_found_by_its_own_configuration_needs_no_newer_cmake(
    tree: Tree, words: str, asked: list[str]
) -> None:
    lines = f"find_package({words})\n{LINK.format('GTest::gtest')}"
    decision = tree(ros1("melodic", "Boost", lines))
    assert [each.text for each in decision.python.pip_guessed if each.key == "cmake"] == asked


FETCHED = "FetchContent_Declare({0} GIT_REPOSITORY https://github.com/lab/{0}.git)\nFetchContent_MakeAvailable({0})\n"


@pytest.mark.parametrize(
    ("lines", "more", "found"),
    [
        (FETCHED.format("yaml-cpp"), {}, []),
        (FETCHED.format("other"), {}, [("yaml-cpp", "0.8.0")]),
        ("if(NOT TARGET yaml-cpp::yaml-cpp)\nadd_library(yaml-cpp::yaml-cpp INTERFACE IMPORTED)\nendif()\n", {}, []),
        (
            "add_subdirectory(lib/yaml-cpp)\n",
            {".gitmodules": '[submodule "y"]\n\tpath = lib/yaml-cpp\n\turl = https://github.com/jbeder/yaml-cpp.git\n'},
            [],
        ),
    ],
)
def test_what_the_project_brings_itself_is_not_built(
    tree: Tree, lines: str, more: dict[str, str], found: list[tuple[str, str]]
) -> None:
    text = CMAKE.format(package="Eigen3", link=f"{lines}{LINK.format('yaml-cpp::yaml-cpp')}")
    files = ros1("noetic", "Eigen3", "")
    assert [each for each in built(tree({**files, **more, "CMakeLists.txt": text})) if each[0] == "yaml-cpp"] == found
