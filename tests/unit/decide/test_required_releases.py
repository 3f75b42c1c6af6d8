"""A release that CMake requires, and that the Ubuntu does not have, is built where the table of recipes has one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(a)\nfind_package({})\nadd_executable(a a.cpp)\n"
ON = "Tested on Ubuntu {}\n"


def built(decision: Decision) -> list[tuple[str, str | None]]:
    return [(source.name, source.ref) for source in decision.source]


@pytest.mark.parametrize(
    ("asked", "ubuntu", "ref"),
    [
        ("OpenCV 3.4 REQUIRED", "18.04", "3.4.16"),  # it has 3.2
        ("OpenCV 3.4 REQUIRED", "20.04", "3.4.16"),  # it has 4.2
    ],
)
def test_a_release_that_the_ubuntu_lacks_is_built(tree: Tree, asked: str, ubuntu: str, ref: str) -> None:
    decision = tree({"CMakeLists.txt": CMAKE.format(asked), "README.md": ON.format(ubuntu)})
    assert built(decision) == [("opencv", ref)]
    assert "libavcodec-dev" in decision.apt_guessed
    assert not any("CMake requires" in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    "asked", ["OpenCV 3 REQUIRED", "OpenCV REQUIRED", "OpenCV 3.4", "OpenCV 5.1 REQUIRED", "Ceres 1.13 REQUIRED"]
)
def test_one_that_it_has_or_that_no_row_has_is_not(tree: Tree, asked: str) -> None:
    assert built(tree({"CMakeLists.txt": CMAKE.format(asked), "README.md": ON.format("18.04")})) == []


@pytest.mark.parametrize(
    ("asked", "distro", "found"),
    [
        ("Eigen3 3.4 REQUIRED", "noetic", ("eigen3", "3.4.0")),  # focal has 3.3.7
        ("fmt 7 REQUIRED", "noetic", ("fmt", "7.1.3")),  # focal has 6.1.2
        ("fmt 8.0 REQUIRED", "noetic", ("fmt", "8.1.1")),
        ("spdlog 1.8 REQUIRED", "noetic", ("spdlog", "v1.9.2")),
        ("nlohmann_json 3.2.0 REQUIRED", "melodic", ("nlohmann_json", "v3.7.3")),
        ("nlohmann_json 3.11 REQUIRED", "humble", ("nlohmann_json", "v3.11.2")),
        ("yaml-cpp 0.7 REQUIRED", "noetic", ("yaml-cpp", "0.8.0")),
        ("Catch2 3 REQUIRED", "humble", ("catch2", "v3.4.0")),
        ("Eigen3 3.3 REQUIRED", "noetic", None),
        ("fmt 6 REQUIRED", "noetic", None),
        ("nlohmann_json 3.7 REQUIRED", "noetic", None),
        ("yaml-cpp 0.6 REQUIRED", "noetic", None),
        ("Catch2 3 REQUIRED", "jazzy", None),
    ],
)
def test_small_libraries_come_in_the_release_that_is_asked_for(
    tree: Tree, asked: str, distro: str, found: tuple[str, str] | None
) -> None:
    tool = "catkin" if distro in {"melodic", "noetic"} else "ament_cmake"
    files = {
        "package.xml": f"<package><name>demo</name><buildtool_depend>{tool}</buildtool_depend></package>",
        "CMakeLists.txt": f"project(demo)\nfind_package({tool} REQUIRED)\nfind_package({asked})\n",
    }
    decision = tree({**files, "README.md": f"For ROS {distro}\n"})
    assert built(decision) == ([found] if found else [])
    assert not any("CMake requires" in warning.message for warning in decision.warnings)
    beside = [warning for warning in decision.warnings if "is built beside the release" in warning.message]
    assert bool(beside) is bool(found and found[0] in {"eigen3", "spdlog", "yaml-cpp"})


@pytest.mark.parametrize(("ubuntu", "found"), [("20.04", [("cli11", "v2.1.2")]), ("22.04", [])])
def test_a_library_that_newer_ubuntus_have_is_built_on_an_older_one(
    tree: Tree, ubuntu: str, found: list[tuple[str, str]]
) -> None:
    decision = tree({"CMakeLists.txt": CMAKE.format("CLI11 REQUIRED"), "README.md": ON.format(ubuntu)})
    assert built(decision) == found
    assert ("libcli11-dev" in (*decision.apt, *decision.apt_guessed)) is not bool(found)


@pytest.mark.parametrize(
    ("asked", "ubuntu", "found", "brought"),
    [
        ("ruckig", "22.04", [("ruckig", "v0.9.2")], set()),
        ("ifopt", "20.04", [("ifopt", "2.1.3")], {"coinor-libipopt-dev", "libeigen3-dev"}),
        ("qpOASES", "22.04", [("qpoases", "36362520bdbcdec79343e00999cc71e8ad69b622")], set()),
        ("autodiff", "22.04", [("autodiff", "98a5565305ad4700d84f8272bb441f848ecae6b6")], {"libeigen3-dev"}),
        ("fbow", "20.04", [("fbow", "2dd957c8e2b4c7a4e007dd3cfb901a250e299daa")], {"libopencv-dev"}),
        ("magic_enum", "22.04", [("magic_enum", "v0.9.7")], set()),
        ("cereal", "22.04", [("cereal", "v1.3.2")], set()),
        ("cereal", "24.04", [], {"libcereal-dev"}),
        ("apriltag", "18.04", [("apriltag", "v3.3.0")], set()),
        ("apriltag", "22.04", [], {"libapriltag-dev"}),
        ("VISP", "22.04", [], {"libvisp-dev"}),
        ("PahoMqttCpp", "22.04", [], {"libpaho-mqttpp-dev", "libpaho-mqtt-dev"}),
    ],
)
def test_a_library_without_a_package_is_built(
    tree: Tree, asked: str, ubuntu: str, found: list[tuple[str, str]], brought: set[str]
) -> None:
    cmake = CMAKE.format(f"{asked} REQUIRED")
    decision = tree({"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": ON.format(ubuntu)})
    assert built(decision) == found
    assert brought <= {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(
    ("call", "ref"),
    [
        ("ExternalProject_Add(magic_enum GIT_REPOSITORY {} GIT_TAG v0.9.6)", "v0.9.6"),
        ('add_needed(\n  NAME magic_enum\n  VERSION ${{V}} GIT_REPOSITORY "{}"\n  GIT_TAG v${{V}})', "v0.9.6"),
        ("add_needed(NAME magic_enum GIT_REPOSITORY {} GIT_TAG master)", "v0.9.7"),
        ('message(STATUS "GIT_REPOSITORY {} GIT_TAG v1")', "v0.9.7"),
    ],
)
def test_it_is_built_as_the_trees_own_cmake_fetches_it(tree: Tree, call: str, ref: str) -> None:
    own = call.format("https://github.com/Neargye/magic_enum.git")
    decision = tree(
        {
            "CMakeLists.txt": CMAKE.format("magic_enum REQUIRED"),
            "externals/CMakeLists.txt": f"project(needed)\nset(V 0.9.6)\n{own}\n",
            "README.md": ON.format("22.04"),
        }
    )
    assert built(decision) == [("magic_enum", ref)]


def test_a_ros_that_has_a_small_library_brings_it(tree: Tree) -> None:
    manifest = "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    cmake = "project(demo)\nfind_package(ament_cmake REQUIRED)\nfind_package(ruckig REQUIRED)\n"
    decision = tree({"package.xml": manifest, "CMakeLists.txt": cmake, "README.md": "For ROS humble\n"})
    assert built(decision) == []
    assert "ros-humble-ruckig" in decision.apt_guessed


def test_an_example_is_no_reason(tree: Tree) -> None:
    files = {
        "CMakeLists.txt": CMAKE.format("Eigen3 REQUIRED"),
        "examples/b/CMakeLists.txt": CMAKE.format("OpenCV 3.4 REQUIRED"),
    }
    assert built(tree({**files, "README.md": ON.format("18.04")})) == []


@pytest.mark.parametrize(
    ("asked", "code", "ref"),
    [
        ("pinocchio REQUIRED", "", "v2.7.1"),
        ("pinocchio 3.1 REQUIRED", "", "v3.3.1"),
        ("pinocchio REQUIRED", "#include <pinocchio/algorithm/constrained-dynamics.hpp>\n", "v3.3.1"),
    ],
)
def test_pinocchio_is_built_after_its_library_of_collisions(tree: Tree, asked: str, code: str, ref: str) -> None:
    decision = tree({"CMakeLists.txt": CMAKE.format(asked), "a.cpp": code, "README.md": ON.format("22.04")})
    assert built(decision) == [("hpp-fcl", "v2.4.5"), ("pinocchio", ref)]
    assert {"liburdfdom-dev", "libassimp-dev"} <= {*decision.apt_guessed, *decision.apt}


def test_a_workspace_gets_it_too(tree: Tree) -> None:
    asked = "".join(f"find_package({each} REQUIRED)\n" for each in ("ament_cmake", "OpenCV 4.9.0"))
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
        "CMakeLists.txt": f"project(demo)\n{asked}",
        ".github/workflows/a.yml": "container: ros:humble\n",
    }
    assert built(tree({**files, "README.md": "For ROS 2 Humble.\n"})) == [("opencv", "4.9.0")]


@pytest.mark.parametrize("distro", ["melodic", "humble"])
def test_a_ros_that_has_it_brings_it(tree: Tree, distro: str) -> None:
    tool = "catkin" if distro == "melodic" else "ament_cmake"
    manifest = f"<package><name>demo</name><buildtool_depend>{tool}</buildtool_depend></package>"
    asked = "".join(f"find_package({name} REQUIRED)\n" for name in (tool, "pinocchio", "hpp-fcl"))
    decision = tree(
        {"package.xml": manifest, "CMakeLists.txt": f"project(demo)\n{asked}", "README.md": f"For ROS {distro}\n"}
    )
    assert built(decision) == []
    assert {f"ros-{distro}-pinocchio", f"ros-{distro}-hpp-fcl"} <= {*decision.apt_guessed}


@pytest.mark.parametrize(
    ("asked", "ycm", "yarp"),
    [
        ("find_package(YCM REQUIRED)", "v0.15.3", None),
        ("find_package(YCM 0.15 REQUIRED)", "v0.15.3", None),
        ("find_package(YCM 0.18.2 REQUIRED)\nfind_package(YARP 3.12 REQUIRED)", "v0.18.2", "v3.12.0"),
        ("find_package(YARP 3.8.1 REQUIRED)", "v0.15.3", "v3.9.0"),
        ("set(YCM_REQUIRED_VERSION 0.18.2)\nfind_package(YCM ${YCM_REQUIRED_VERSION} REQUIRED)", "v0.18.2", None),
    ],
)
def test_a_newer_release_than_the_tables_is_built_by_its_tag(
    tree: Tree, asked: str, ycm: str, yarp: str | None
) -> None:
    cmake = f"cmake_minimum_required(VERSION 3.12)\nproject(a)\n{asked}\nadd_executable(a a.cpp)\n"
    decision = tree({"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": ON.format("22.04")})
    assert built(decision) == [("ycm", ycm), *([("yarp", yarp)] if yarp else [])]
    assert not any("CMake requires" in warning.message for warning in decision.warnings)
