"""The script that compiles packages one by one where a clone brings one that catkin_make refuses."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/plain-apart.sh"
REFUSED = "  This workspace contains non-catkin packages in it, and catkin cannot build"
"""What catkin_make says of such a workspace.

https://github.com/ros/catkin/blob/noetic-devel/cmake/catkin_workspace.cmake, 2026-11-28
"""


def _run(workspace: Path, said: str, *words: str, apart: bool = True) -> tuple[int, list[str]]:
    """Return how the script ends, and what was called, with a catkin_make that says that and fails."""
    programs = workspace / "programs"
    programs.mkdir(exist_ok=True)
    made = f"mkdir -p build devel && echo '{said}' >&2 && exit {int(bool(said))}"
    one_by_one = "mkdir -p build_isolated devel_isolated && touch devel_isolated/setup.bash" if apart else "exit 1"
    for name, does in (("catkin_make", made), ("catkin_make_isolated", one_by_one)):
        program = programs / name
        program.write_text(f'#!/bin/bash\necho "{name} $*" >>{workspace}/called\n{does}\n')
        program.chmod(0o755)
    ran = subprocess.run(
        ["bash", SCRIPT, "env", "catkin_make", "-j2", "-DA=b c", *words],
        cwd=workspace,
        env={**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )
    return ran.returncode, (workspace / "called").read_text().splitlines()


def test_a_workspace_of_catkin_alone_is_compiled_as_it_was(tmp_path: Path) -> None:
    assert _run(tmp_path, "") == (0, ["catkin_make -j2 -DA=b c"])
    assert not (tmp_path / "devel").is_symlink()


def test_one_that_catkin_make_refuses_is_compiled_package_by_package(tmp_path: Path) -> None:
    isolated = "catkin_make_isolated -j2 --cmake-args -DA=b c"
    assert _run(tmp_path, REFUSED) == (0, ["catkin_make -j2 -DA=b c", isolated])
    assert (tmp_path / "devel/setup.bash").exists()
    assert [(tmp_path / name).readlink().name for name in ("build", "devel")] == ["build_isolated", "devel_isolated"]
    assert _run(tmp_path, REFUSED)[1][2:] == [isolated], "once more, as where a package was left out since"


@pytest.mark.parametrize(("said", "apart", "calls"), [("fatal error: a.h", True, 1), (REFUSED, False, 2)])
def test_what_fails_for_another_reason_fails(tmp_path: Path, said: str, apart: bool, calls: int) -> None:
    code, called = _run(tmp_path, said, apart=apart)
    assert (code, len(called)) == (1, calls)


@pytest.mark.usefixtures("scripts_on_path")
def test_packages_that_are_left_out_stay_so(tmp_path: Path) -> None:
    for name in ("kept", "lost", "also_lost"):
        (tmp_path / "src" / name).mkdir(parents=True)
        manifest = f"<package><name>{name}</name><depend>kept</depend></package>\n"
        (tmp_path / "src" / name / "package.xml").write_text(manifest)
    code, called = _run(tmp_path, REFUSED, "-DCATKIN_BLACKLIST_PACKAGES=lost;also_lost")
    assert (code, called[1:]) == (0, ["catkin_make_isolated -j2 --cmake-args -DA=b c"])
    assert sorted(marker.parent.name for marker in tmp_path.rglob("CATKIN_IGNORE")) == ["also_lost", "lost"]


def test_a_part_with_what_it_needs_is_compiled_into_one_folder(tmp_path: Path) -> None:
    assert _run(tmp_path, REFUSED, "--only-pkg-with-deps", "demo")[1][1:] == [
        "catkin_make_isolated -j2 --merge --only-pkg-with-deps demo --cmake-args -DA=b c"
    ]
