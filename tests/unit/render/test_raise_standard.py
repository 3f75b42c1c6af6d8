"""The script that raises the standard of C++ of cloned packages, and where it is called."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.knowledge.cpp_standards import raised

pytestmark = pytest.mark.usefixtures("scripts_on_path")
NAMES = "PCL pcl pcl_ros"


def _package(root: Path, path: str, cmake: str, *depends: str) -> Path:
    folder = root / "src" / path
    folder.mkdir(parents=True)
    lines = "".join(f"  <depend>{each}</depend>\n" for each in depends)
    (folder / "package.xml").write_text(f"<package>\n  <name>{folder.name}</name>\n{lines}</package>\n")
    (folder / "CMakeLists.txt").write_text(f"{cmake}\n")
    return folder / "CMakeLists.txt"


def _run(root: Path, *folders: str) -> str:
    command = ["raise-standard", "14", NAMES, *folders]
    return subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize(
    ("cmake", "after"),
    [
        ("add_definitions(-std=c++11)", "add_definitions(-std=c++14)"),
        ("add_definitions(-std=c++0x -Wall)", "add_definitions(-std=c++14 -Wall)"),
        ('set(CMAKE_CXX_FLAGS "-std=gnu++11")', 'set(CMAKE_CXX_FLAGS "-std=gnu++14")'),
        ("set(CMAKE_CXX_STANDARD 11)", "set(CMAKE_CXX_STANDARD 14)"),
        ("target_compile_features(a PUBLIC cxx_std_11)", "target_compile_features(a PUBLIC cxx_std_14)"),
        ("add_definitions(-std=c++17)", "add_definitions(-std=c++17)"),
        ("set(CMAKE_CXX_STANDARD 14)", "set(CMAKE_CXX_STANDARD 14)"),
    ],
)
def test_older_standards_are_raised(tmp_path: Path, cmake: str, after: str) -> None:
    file = _package(tmp_path, "map", cmake, "pcl_ros")
    said = _run(tmp_path, "src")
    assert file.read_text() == f"{after}\n"
    told = "roslab: map is compiled as C++14, which a library that it needs asks for\n"
    assert said == (told if after != cmake else "")


def test_those_that_need_one_in_turn_and_no_others(tmp_path: Path) -> None:
    old, new = "add_definitions(-std=c++11)", "add_definitions(-std=c++14)\n"
    by_cmake = _package(tmp_path, "lib/by_cmake", f"find_package(PCL REQUIRED)\n{old}")
    in_turn = _package(tmp_path, "lib/in_turn", old, "by_cmake")
    header = _package(tmp_path, "lib/header", old)
    (header.parent / "a.h").write_text("#include <pcl/point_types.h>\n")
    other = _package(tmp_path, "lib/other", old, "roscpp")
    own = _package(tmp_path, "paper/own", old, "pcl_ros")
    hidden = _package(tmp_path, "lib/hidden", old, "pcl_ros")
    (hidden.parent / "CATKIN_IGNORE").touch()
    said = _run(tmp_path, "src", "--but", "src/paper")
    assert [line.split()[1] for line in said.splitlines()] == ["by_cmake", "header", "in_turn"]
    assert in_turn.read_text() == header.read_text() == new
    assert by_cmake.read_text().endswith(new)
    assert {file.read_text() for file in (other, own, hidden)} == {f"{old}\n"}


def test_only_an_ubuntu_whose_library_refuses_the_older_one() -> None:
    assert [standard for standard, _ in raised("focal")] == ["14"]
    assert "pcl_ros" in raised("focal")[0][1].split()
    assert raised("bionic") == raised(None) == ()
