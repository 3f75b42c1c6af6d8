"""The script that completes package.xml files by what CMake requires of the workspace."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")


def _package(root: Path, name: str, cmake: str, *depends: str) -> Path:
    folder = root / "src" / name
    folder.mkdir(parents=True)
    lines = "".join(f"  <depend>{each}</depend>\n" for each in depends)
    (folder / "package.xml").write_text(f"<package>\n  <name>{name}</name>\n{lines}</package>\n")
    (folder / "CMakeLists.txt").write_text(f"project({name})\n{cmake}\n")
    return folder / "package.xml"


def _named(manifest: Path) -> list[str]:
    return re.findall(r"<(?:build_)?depend>(\w+)<", manifest.read_text())


def _run(root: Path) -> str:
    command = ["declare-needs", "src"]
    return subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize(
    ("cmake", "depends", "named"),
    [
        ("find_package(catkin REQUIRED COMPONENTS roscpp utils)", [], ["utils"]),
        ("find_package(ament_cmake REQUIRED)\nfind_package(utils REQUIRED)", [], ["utils"]),
        ("find_package(catkin REQUIRED COMPONENTS\n  utils # pose\n)", ["roscpp"], ["roscpp", "utils"]),
        ("find_package(catkin REQUIRED COMPONENTS utils)", ["utils"], ["utils"]),
        ("find_package(catkin REQUIRED COMPONENTS roscpp)", [], []),
        ("find_package(utils)", [], []),
        ("# find_package(catkin REQUIRED COMPONENTS utils)", [], []),
    ],
)
def test_what_cmake_requires_of_the_workspace(tmp_path: Path, cmake: str, depends: list[str], named: list[str]) -> None:
    user = _package(tmp_path, "arm", cmake, *depends)
    _package(tmp_path, "utils", "find_package(catkin REQUIRED)")
    said = _run(tmp_path)
    assert _named(user) == named
    assert said == (
        ""
        if named == depends
        else "roslab: arm requires utils, which its package.xml does not name: it is named there\n"
    )
    assert not _run(tmp_path)


@pytest.mark.parametrize(
    ("path", "named"), [("sdk/CMakeLists.txt", ["arm_sdk"]), ("arm_sdk/CMakeLists.txt", []), ("sdk/cmake/a.txt", [])]
)
def test_a_project_without_a_manifest(tmp_path: Path, path: str, named: list[str]) -> None:
    user = _package(tmp_path, "arm", "find_package(arm_sdk 1.2 REQUIRED)")
    if not named:
        _package(tmp_path, "sdk", "")
    made = tmp_path / "src" / path
    made.parent.mkdir(parents=True, exist_ok=True)
    name = "arm_sdk" if named else "other"
    made.write_text(f"cmake_minimum_required(VERSION 3.16)\n\nProject( {name} VERSION 1.3.0)\n")
    assert ("arm requires arm_sdk" in _run(tmp_path)) is bool(named)
    assert _named(user) == named


@pytest.mark.parametrize(
    ("config", "cmake", "named"),
    [
        ("cmake/ArmConfig.cmake.in", "configure_package_config_file(cmake/ArmConfig.cmake.in ArmConfig.cmake)", True),
        ("arm-config.cmake", "install(FILES arm-config.cmake DESTINATION lib/cmake/arm)", True),
        ("cmake/ArmConfig.cmake", "list(APPEND CMAKE_MODULE_PATH cmake)", False),  # how it finds another one
        ("cmake/Config.cmake.in", "install(FILES ArmConfig.cmake DESTINATION lib)", False),
    ],
)
def test_a_library_that_cmake_finds_by_another_name(tmp_path: Path, config: str, cmake: str, *, named: bool) -> None:
    wanted = "arm" if config.startswith("arm") else "Arm"
    user = _package(tmp_path, "driver", f"find_package({wanted} 0.13 REQUIRED)", "arm_msgs")
    own = _package(tmp_path, "libarm", f"{cmake}\nfind_package({wanted} REQUIRED)")
    made = own.parent / config
    made.parent.mkdir(exist_ok=True)
    made.touch()
    assert ("driver requires libarm" in _run(tmp_path)) is named
    assert _named(user) == (["arm_msgs", "libarm"] if named else ["arm_msgs"])
    assert _named(own) == []
    assert not _run(tmp_path)


def test_a_link_to_another_machines_distribution_is_no_project(tmp_path: Path) -> None:
    user = _package(tmp_path, "arm", "find_package(catkin REQUIRED COMPONENTS utils)")
    _package(tmp_path, "utils", "")
    (tmp_path / "src/CMakeLists.txt").symlink_to("/opt/ros/none/share/catkin/cmake/toplevel.cmake")
    _run(tmp_path)
    assert _named(user) == ["utils"]


def test_packages_that_need_each_other_stay_as_they_are(tmp_path: Path) -> None:
    first = _package(tmp_path, "a", "find_package(catkin REQUIRED COMPONENTS c)")
    _package(tmp_path, "b", "", "a")
    third = _package(tmp_path, "c", "find_package(catkin REQUIRED COMPONENTS a)", "b")
    assert "roslab: c requires a" in _run(tmp_path)
    assert (_named(first), _named(third)) == ([], ["b", "a"])


def test_a_package_that_is_passed_by_is_none(tmp_path: Path) -> None:
    user = _package(tmp_path, "arm", "find_package(catkin REQUIRED COMPONENTS utils)")
    _package(tmp_path, "utils", "").with_name("CATKIN_IGNORE").touch()
    assert not _run(tmp_path)
    assert _named(user) == []
