"""Code that needs a newer compiler than the Ubuntu of its ROS has."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan

PACKAGE = (
    "<package format='3'><name>demo</name><version>1.0.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend></package>"
)
CMAKE = "project(demo)\nfind_package(rclcpp REQUIRED)\nadd_executable(demo main.cpp)\nament_package()\n"
FORMAT = "#include <format>\nint main() {}\n"


KINETIC = PACKAGE.replace("ament_cmake", "catkin").replace("rclcpp", "roscpp").replace("format='3'", "format='2'")


def plan(folder: Path, files: dict[str, str]) -> Plan:
    for name, text in {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, **files}.items():
        (folder / name).write_text(text)
    return plan_repository(folder).plan


@pytest.mark.parametrize(
    ("lines", "code", "version", "repository"),
    [
        ("base: {ros: humble}\n", FORMAT, "13", "ppa:ubuntu-toolchain-r/test"),
        ("base: {ros: jazzy}\n", FORMAT, "", ""),
        ("base: {ros: humble}\n", "#include <span>\nint main() {}\n", "", ""),
        ("base: {ros: humble}\nenv: {CXX: g++-13}\n", FORMAT, "", ""),
        ("base: {ros: humble}\napt: [g++-13]\n", FORMAT, "13", "ppa:ubuntu-toolchain-r/test"),
        ("base: {ros: humble}\napt: [g++-12]\n", FORMAT, "13", "ppa:ubuntu-toolchain-r/test"),
        (
            "base: {ros: humble}\nrepo: ['ppa:ubuntu-toolchain-r/test']\napt: [g++-13]\n",
            FORMAT,
            "13",
            "ppa:ubuntu-toolchain-r/test",
        ),
        ("base: {ros: foxy}\n", "#include <span>\nint main() {}\n", "10", ""),
        ("base: {ros: humble}\napt: [g++-12]\n", "int main() {}\n", "12", ""),
        ("base: {ros: humble}\napt: [g++-10]\n", "int main() {}\n", "", ""),
    ],
)
def test_a_newer_compiler_is_installed_and_compiles(
    tmp_path: Path, lines: str, code: str, version: str, repository: str
) -> None:
    found = plan(tmp_path, {"main.cpp": code, "roslab.yaml": f"format: 3\n{lines}"})
    wanted = (("CC", f"gcc-{version}"), ("CXX", f"g++-{version}")) if version else ()
    assert found.workspace is not None
    assert found.workspace.variables == wanted
    assert found.repositories == ((repository,) if repository else ())
    assert not version or f"g++-{version}" in found.apt
    assert not any("needs GCC" in each.message for each in found.warnings)


def test_the_compiler_that_a_page_installs_is_taken(tmp_path: Path) -> None:
    page = (
        "# Demo\nROS Kinetic\n```\nsudo add-apt-repository ppa:ubuntu-toolchain-r/test\nsudo apt-get update\n"
        "sudo apt-get install gcc-snapshot gcc-8 g++-8\n```\n"
    )
    cmake = CMAKE.replace("ament_package", "catkin_package").replace("rclcpp", "catkin")
    cmake = cmake.replace("(demo)\n", '(demo)\nset(CMAKE_CXX_FLAGS "-std=c++17")\n', 1)
    files = {"package.xml": KINETIC, "CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", "README.md": page}
    found = plan(tmp_path, {**files, "roslab.yaml": "format: 3\nbase: {ros: kinetic}\n"})
    assert found.workspace is not None
    assert found.workspace.variables == (("CC", "gcc-8"), ("CXX", "g++-8"))
    assert found.repositories == ("ppa:ubuntu-toolchain-r/test",)
    assert "g++-8" in found.apt
    assert "g++-8" not in found.apt_guessed


@pytest.mark.parametrize(
    ("line", "version"),
    [
        ("add_compile_options(-std=c++20)", "10"),
        ('set(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} -std=gnu++20 -O3")', "10"),
        ("target_compile_options(demo PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-std=c++20>)", "10"),
        ('string(APPEND CMAKE_CXX_FLAGS " -std=c++20")', "10"),
        ("list(APPEND CXX_OPTIONS -std=c++20)", "10"),
        ("list(REMOVE_ITEM CXX_OPTIONS -std=c++20)", ""),
        ('string(REPLACE "-std=c++20" "-std=c++17" CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS}")', ""),
        ("set(CMAKE_CXX_STANDARD 20)", ""),
        ("add_compile_options(-std=c++2a)", ""),
        ("# add_compile_options(-std=c++20)", ""),
        ('check_cxx_compiler_flag("-std=c++20" HAS_20)\nif(HAS_20)\nadd_compile_options(-std=c++20)\nendif()', ""),
    ],
)
def test_an_option_names_a_standard_as_a_newer_compiler_does(tmp_path: Path, line: str, version: str) -> None:
    """GCC 9 knows c++2a alone, which is what CMake asks of it for the variable."""
    files = {"main.cpp": "int main() {}\n", "roslab.yaml": "format: 3\nbase: {ros: foxy}\n"}
    found = plan(tmp_path, {**files, "CMakeLists.txt": f"{CMAKE}{line}\n"})
    assert found.workspace is not None
    assert found.workspace.variables == ((("CC", f"gcc-{version}"), ("CXX", f"g++-{version}")) if version else ())


def test_where_none_is_known_it_is_told(tmp_path: Path) -> None:
    lines = "format: 3\nbase: {ros: foxy}\n"
    cmake = CMAKE.replace("(demo)\n", "(demo)\nset(CMAKE_CXX_STANDARD 23)\n", 1)
    cuda = cmake.replace("(demo)\n", "(demo LANGUAGES CXX CUDA)\nfind_package(CUDA REQUIRED)\n", 1)
    files = {"CMakeLists.txt": cuda, "main.cpp": "int main() {}\n", "roslab.yaml": f"{lines}kind: cuda\n"}
    assert any("needs GCC 11" in each.message for each in plan(tmp_path, files).warnings)


TRAVIS = """dist: trusty
env: ROS_DISTRO=indigo {env}
addons:
  apt:
    sources: [ubuntu-toolchain-r-test]
    packages: [{packages}]
install: sudo apt-get install -y ros-indigo-catkin
"""


@pytest.mark.parametrize(
    ("packages", "version"),
    [("g++-4.9", "4.9"), ("g++-6, gcc-6", "6"), ("g++-4.9, g++-6", ""), ("gcc-6", ""), ("g++-4.8", "")],
)
def test_the_only_newer_compiler_of_the_authors_ci_compiles(tmp_path: Path, packages: str, version: str) -> None:
    cmake = CMAKE.replace("ament_package", "catkin_package").replace("rclcpp", "catkin")
    travis = TRAVIS.format(env="CXX=g++-4.9", packages=packages)
    files = {"package.xml": KINETIC, "CMakeLists.txt": cmake, "main.cpp": "int main() {}\n", ".travis.yml": travis}
    found = plan(tmp_path, files)
    assert found.ubuntu == "trusty"
    assert found.workspace is not None
    assert found.workspace.variables == ((("CC", f"gcc-{version}"), ("CXX", f"g++-{version}")) if version else ())
    assert found.repositories == (("ppa:ubuntu-toolchain-r/test",) if version else ())
    assert (f"g++-{version}" in found.apt) is bool(version)


def test_one_that_the_ubuntu_cannot_have_is_not_taken(tmp_path: Path) -> None:
    page = "ROS Jazzy\n```\nsudo apt-get install g++-15\n```\n"
    found = plan(tmp_path, {"main.cpp": "int main() {}\n", "README.md": page})
    assert found.ubuntu == "noble"
    assert found.workspace is not None
    assert found.workspace.variables == ()
    assert "g++-15" in found.apt_guessed


@pytest.mark.parametrize(("links", "version"), [("target_link_libraries(demo stdc++fs)\n", "8"), ("", "9")])
def test_what_does_not_link_the_library_of_file_systems_gets_a_compiler_without_it(
    tmp_path: Path, links: str, version: str
) -> None:
    cmake = CMAKE.replace("ament_package", "catkin_package").replace("rclcpp", "catkin") + links
    code = "#include <filesystem>\nint main() {}\n"
    files = {"package.xml": KINETIC, "CMakeLists.txt": cmake, "main.cpp": code}
    found = plan(tmp_path, {**files, "roslab.yaml": "format: 3\nbase: {ros: melodic}\n"})
    assert found.workspace is not None
    assert found.workspace.variables == (("CC", f"gcc-{version}"), ("CXX", f"g++-{version}"))
