"""The script that builds a workspace without what failed of cloned repositories."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")

COLCON = """\
Starting >>> mine
--- stderr: camera
CMake Error at CMakeLists.txt:9 (find_package):
  Could not find a package configuration file provided by "SDK"
---
Failed   <<< camera [0.61s, exited with code 1]
Aborted  <<< mine [0.66s]
"""
ISOLATED = "<== Failed to process package 'camera': \n  Command '['cmake']' returned non-zero exit status 1.\n"
TOOLS = """\
Errors     << camera:cmake /ws/logs/camera/build.cmake.000.log
Failed     << camera:cmake [ Exited with code 1 ]
"""
CATKIN = """\
CMake Warning at mine/CMakeLists.txt:4 (find_package):
  Could not find a package configuration file provided by "other"

CMake Error at /opt/ros/noetic/share/catkin/cmake/catkinConfig.cmake:83 (find_package):
  Could not find a package configuration file provided by "sdk"
Call Stack (most recent call first):
  clone/camera/CMakeLists.txt:6 (find_package)


-- Configuring incomplete, errors occurred!
"""
OBJECT = "clone/camera/CMakeFiles/camera.dir/a.cpp.o"
MADE = f"make[2]: *** [clone/camera/CMakeFiles/camera.dir/build.make:76: {OBJECT}] Error 1\n"
OLD = f"make[2]: *** [{OBJECT}] Error 1\n"


def _package(workspace: Path, path: str, name: str) -> None:
    (workspace / "src" / path).mkdir(parents=True)
    (workspace / "src" / path / "package.xml").write_text(f"<package>\n  <name>{name}</name>\n</package>\n")


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Return a workspace with a package of its own and a clone with two."""
    _package(tmp_path, "mine", "mine")
    _package(tmp_path, "clone/camera", "camera")
    _package(tmp_path, "clone/msgs", "camera_msgs")
    return tmp_path


def _run(workspace: Path, log: str, *options: str, failing: str = "clone/camera") -> tuple[int, list[str], str]:
    """Build while the failing package is not hidden; return the exit code, what is hidden, and what was said."""
    (workspace / "log").write_text(log)
    tool = f"[ -e src/{failing}/CATKIN_IGNORE ] || {{ cat log; exit 3; }}; echo built"
    ran = subprocess.run(
        ["leave-out-failed", *options, "src/clone", "--", "bash", "-c", tool],
        cwd=workspace,
        capture_output=True,
        text=True,
        check=False,
    )
    return ran.returncode, sorted(file.parent.name for file in workspace.rglob("COLCON_IGNORE")), ran.stdout


@pytest.mark.parametrize("log", [COLCON, ISOLATED, TOOLS, CATKIN, MADE, OLD])
def test_what_failed_of_a_clone_is_left_out_and_told(workspace: Path, log: str) -> None:
    code, hidden, said = _run(workspace, log)
    assert (code, hidden) == (0, ["camera"])
    assert said.index("roslab: left out: camera\n") < said.index("built")


@pytest.mark.parametrize(("named", "left"), [("camera", ["tool"]), ("camera_tool", None)])
def test_a_project_without_a_package_xml_is_left_out_by_its_name(
    workspace: Path, named: str, left: list[str] | None
) -> None:
    (workspace / "src/clone/tool").mkdir()
    (workspace / "src/clone/tool/CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.5)\nProject( {named} VERSION 1)\n"
    )
    (workspace / "src/clone/camera/package.xml").write_text("<package><name>other</name></package>\n")
    code, hidden, said = _run(workspace, COLCON, "src/clone/tool", failing="clone/tool")
    assert (code, hidden) == ((0, left) if left else (1, []))
    assert ("roslab: left out: tool\n" in said) is bool(left)


@pytest.mark.parametrize("log", [COLCON, CATKIN, MADE])
def test_what_the_command_starts_is_kept(workspace: Path, log: str) -> None:
    code, hidden, said = _run(workspace, log, "--keep", "camera")
    assert (code, hidden) == (1, [])
    assert log in said


@pytest.mark.parametrize("log", [log.replace("camera", "mine").replace("clone/", "") for log in (COLCON, CATKIN, OLD)])
def test_what_is_no_clone_stops_the_build(workspace: Path, log: str) -> None:
    code, hidden, said = _run(workspace, log, failing="mine")
    assert (code, hidden) == (1, [])
    assert "left out" not in said


def test_what_says_nothing_of_packages_stops_the_build(workspace: Path) -> None:
    assert _run(workspace, "no space left on device\n")[:2] == (1, [])


SPARE = ("--spare", "src/mine", "--spare", "src/other", "--spare", "src/third")


@pytest.mark.parametrize(
    ("options", "code", "hidden"),
    [
        (("--most", "1", *SPARE), 0, ["mine"]),
        (("--most", "0", *SPARE), 1, []),
        (("--most", "1", "--spare", "src/other"), 1, []),
        (("--keep", "mine", "--most", "1", *SPARE), 1, []),
    ],
)
def test_a_spare_package_is_left_out_up_to_a_number(
    workspace: Path, options: tuple[str, ...], code: int, hidden: list[str]
) -> None:
    log = COLCON.replace("camera", "mine")
    assert _run(workspace, log, *options, failing="mine")[:2] == (code, hidden)


@pytest.mark.parametrize(("own", "code", "left"), [(0, 1, 0), (1, 0, 1), (20, 0, 20)])
def test_the_build_stops_where_hardly_any_package_of_the_repository_is_left(
    workspace: Path, own: int, code: int, left: int
) -> None:
    for number in range(own):
        _package(workspace, f"mine/good{number}", f"good{number}")
    _package(workspace, "mine/camera", "mine_camera")
    (workspace / "src/mine/package.xml").unlink()
    log = COLCON.replace("camera", "mine_camera")
    found, hidden, said = _run(workspace, log, "--own", "src/mine", "src/mine/camera", failing="mine/camera")
    assert (found, hidden) == (code, ["camera"])
    assert ("hardly any builds" in said) == (code == 1)


def test_one_package_of_many_is_hardly_any(workspace: Path) -> None:
    for number in range(11):
        _package(workspace, f"mine/part{number}", f"part{number}")
    (workspace / "src/mine/package.xml").unlink()
    log = "".join(f"Failed   <<< part{number} [1s]\n" for number in range(11))
    found, _, said = _run(workspace, log, "--own", "src/mine", "src/mine", failing="mine/part0")
    assert (found, "hardly any builds" in said) == (1, True)


@pytest.mark.parametrize("inside", ["mine/good/templates/new{}", "mine/old{}"])
def test_what_no_build_tool_finds_is_not_left(workspace: Path, inside: str) -> None:
    _package(workspace, "mine/good", "good")
    _package(workspace, "mine/camera", "mine_camera")
    (workspace / "src/mine/package.xml").unlink()
    for number in range(9):
        _package(workspace, inside.format(number), f"other{number}")
        if "old" in inside:
            (workspace / "src" / inside.format(number) / "COLCON_IGNORE").touch()
    log = COLCON.replace("camera", "mine_camera") + COLCON.replace("camera", "good")
    found, _, said = _run(workspace, log, "--own", "src/mine", "src/mine", failing="mine/camera")
    assert (found, "hardly any builds" in said) == (1, True)
