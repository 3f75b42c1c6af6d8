"""The script that builds a workspace, where that fails without the packages of clones that nothing needs."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")
TOOL = """\
echo built >>attempts
for manifest in $(find src -name package.xml); do
  folder="$(dirname "$manifest")"
  if [ -e "$folder/CATKIN_IGNORE" ]; then continue; fi
  if [ -e "$folder/broken" ]; then exit 2; fi
done
"""
"""What a build tool does: it passes by what has the marker, and stops at what does not compile."""


def _package(workspace: Path, folder: str, name: str, *needed: str, broken: bool = False, **files: str) -> None:
    at = workspace / "src" / folder
    at.mkdir(parents=True, exist_ok=True)
    depends = "".join(f"  <depend>{each}</depend>\n" for each in needed)
    (at / "package.xml").write_text(f"<package>\n  <name>{name}</name>\n{depends}</package>\n")
    for file, text in files.items():
        (at / file.replace("__", ".")).write_text(text)
    if broken:
        (at / "broken").touch()


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Return a workspace in which mine needs lib, which needs msgs; the other packages of the clone are not needed."""
    _package(tmp_path, "mine", "mine", "lib", "roscpp")
    _package(tmp_path, "clone/lib", "lib", "msgs")
    _package(tmp_path, "clone/msgs", "msgs")
    _package(tmp_path, "clone/docs", "docs")
    _package(tmp_path, "clone/tool", "tool", "docs")
    (tmp_path / "tool").write_text(TOOL)
    return tmp_path


def _run(workspace: Path, *options: str) -> tuple[int, int, list[str], str]:
    """Return the exit code, the number of attempts, the packages that were passed by, and what was said."""
    ran = subprocess.run(
        ["build-needed", *options, "src/mine", "bash", "tool"],
        cwd=workspace,
        capture_output=True,
        text=True,
        check=False,
    )
    passed = sorted(file.parent.name for file in workspace.rglob("CATKIN_IGNORE"))
    assert passed == sorted(file.parent.name for file in workspace.rglob("COLCON_IGNORE"))
    return ran.returncode, (workspace / "attempts").read_text().count("built"), passed, ran.stdout


def test_a_workspace_that_builds_is_built_whole(workspace: Path) -> None:
    assert _run(workspace) == (0, 1, [], "")


def test_what_does_not_build_is_left_out_where_nothing_needs_it(workspace: Path) -> None:
    (workspace / "src/clone/docs/broken").touch()
    code, attempts, passed, said = _run(workspace)
    assert (code, attempts, passed) == (0, 2, ["docs", "tool"])
    assert "roslab: left out: docs tool\n" in said


@pytest.mark.parametrize("broken", ["mine", "clone/lib", "clone/msgs"])
def test_what_is_needed_still_stops_the_build(workspace: Path, broken: str) -> None:
    (workspace / "src" / broken / "broken").touch()
    code, attempts, _, _ = _run(workspace)
    assert (code, attempts) == (2, 2)


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("run.launch", '<launch><node pkg="tool" type="tool" name="x"/></launch>'),
        ("node.py", "import tool.msg\n"),
        ("CMakeLists.txt", "find_package(tool REQUIRED)\n"),
    ],
)
def test_what_the_repositorys_files_name_is_needed(workspace: Path, file: str, text: str) -> None:
    (workspace / "src/mine" / file).write_text(text)
    (workspace / "src/clone/docs/broken").touch()
    code, attempts, passed, _ = _run(workspace)
    assert (code, attempts, passed) == (1, 1, []), "tool needs docs, and there is nothing to leave out"


def test_a_page_of_the_repository_names_no_need(workspace: Path) -> None:
    (workspace / "src/mine/README.md").write_text("Unlike tool, this one has no docs.\n")
    (workspace / "src/clone/docs/broken").touch()
    assert _run(workspace)[:3] == (0, 2, ["docs", "tool"])


@pytest.mark.parametrize("marker", ["AMENT_IGNORE", "CATKIN_IGNORE", "COLCON_IGNORE"])
def test_what_a_marker_hides_needs_nothing(workspace: Path, marker: str) -> None:
    _package(workspace, "mine/old", "old", "tool", node__py="import tool.msg\n")
    (workspace / "src/mine/old" / marker).touch()
    _package(workspace, "clone/gone/inner", "gone")
    (workspace / "src/clone/gone" / marker).touch()
    (workspace / "src/clone/docs/broken").touch()
    ran = subprocess.run(
        ["build-needed", "src/mine", "bash", "tool"], cwd=workspace, capture_output=True, text=True, check=False
    )
    assert "roslab: left out: docs tool\n" in ran.stdout
    assert ran.returncode == 0


def test_what_the_command_starts_is_kept(workspace: Path) -> None:
    (workspace / "src/clone/docs/broken").touch()
    assert _run(workspace, "--keep", "docs")[:2] == (2, 2)


def test_no_marker_hides_what_is_needed(workspace: Path) -> None:
    _package(workspace, "clone", "group", broken=True)
    assert _run(workspace)[:3] == (2, 2, ["docs", "tool"])


def test_without_clones_nothing_is_tried_twice(tmp_path: Path) -> None:
    _package(tmp_path, "mine", "mine", broken=True)
    (tmp_path / "tool").write_text(TOOL)
    assert _run(tmp_path)[:3] == (1, 1, [])


def test_a_workspace_of_nothing_but_clones_is_not_emptied(workspace: Path) -> None:
    (workspace / "src/clone/docs/broken").touch()
    shutil.rmtree(workspace / "src/mine")
    assert _run(workspace)[:3] == (1, 1, [])


def test_a_repository_that_needs_none_of_them_hides_none(workspace: Path) -> None:
    (workspace / "src/clone/docs/broken").touch()
    (workspace / "src/mine/package.xml").write_text("<package>\n  <name>mine</name>\n</package>\n")
    assert _run(workspace)[:3] == (1, 1, [])


@pytest.fixture
def submodule(tmp_path: Path) -> Path:
    """Return a workspace in which a folder of mine is somebody else's: mine needs lib of it, and not its server."""
    _package(tmp_path, "mine/robot", "robot", "lib", CMakeLists__txt="project(robot)\n")
    _package(tmp_path, "mine/deps/serial/lib", "lib")
    _package(tmp_path, "mine/deps/serial/server", "server", "lib", CMakeLists__txt="project(server)\n", broken=True)
    (tmp_path / "tool").write_text(TOOL)
    return tmp_path


def test_a_package_of_a_submodule_that_nothing_needs_is_left_out(submodule: Path) -> None:
    assert _run(submodule)[:3] == (1, 1, [])
    assert _run(submodule, "--apart", "deps/serial", "--apart", "deps/absent")[:3] == (0, 3, ["server"])


@pytest.mark.parametrize("broken", ["robot", "deps/serial/lib"])
def test_of_a_submodule_what_is_needed_stops_the_build(submodule: Path, broken: str) -> None:
    (submodule / "src/mine" / broken / "broken").touch()
    assert _run(submodule, "--apart", "deps/serial")[:2] == (2, 2)
    (submodule / "src/mine/deps/serial/server/broken").unlink()
    assert _run(submodule, "--keep", "server", "--apart", "deps/serial")[0] != 0


def test_of_what_was_only_tried_what_nothing_is_compiled_with_is_left_out(workspace: Path) -> None:
    cmake, launch = "find_package(catkin COMPONENTS msgs)\n", '<node pkg="lib"/>\n'
    _package(workspace, "mine", "mine", "lib", "msgs", CMakeLists__txt=cmake, a__launch=launch)
    (workspace / "src/clone/lib/broken").touch()
    code, attempts, passed, said = _run(workspace, "--tried", "clone", "--tried", "absent")
    assert (code, attempts, passed) == (0, 3, ["docs", "lib", "tool"])
    assert said.endswith("roslab: left out: lib\n")


@pytest.mark.parametrize("broken", ["mine", "clone/msgs"])
def test_of_what_was_only_tried_what_code_is_compiled_with_stops_the_build(workspace: Path, broken: str) -> None:
    _package(workspace, "mine", "mine", "lib", CMakeLists__txt="find_package(catkin COMPONENTS lib)\n")
    (workspace / "src" / broken / "broken").touch()
    assert _run(workspace, "--tried", "clone")[0] != 0
