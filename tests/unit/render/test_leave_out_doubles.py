"""The script that hides cloned packages whose names the workspace has already."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")


def hidden(workspace: Path, packages: dict[str, str], *markers: str) -> tuple[list[str], str]:
    """Return the folders that got markers, and what was said; ``packages``: folders with the names of packages."""
    (workspace / "src").mkdir()
    for folder, name in packages.items():
        (workspace / "src" / folder).mkdir(parents=True)
        manifest = f'<package format="2">\n  <name> {name} </name>\n  <author>a</author>\n</package>\n'
        (workspace / "src" / folder / "package.xml").write_text(manifest)
    for folder in markers:
        (workspace / "src" / folder / "CATKIN_IGNORE").touch()
    ran = subprocess.run(
        ["leave-out-doubles", "src/first", "src/second", "src/none"],
        cwd=workspace,
        capture_output=True,
        text=True,
        check=True,
    )
    found = (file.parent.relative_to(workspace / "src") for file in workspace.rglob("COLCON_IGNORE"))
    assert not ran.stderr
    return sorted(map(str, found)), ran.stdout


def test_a_second_copy_of_the_repository(tmp_path: Path) -> None:
    copy = {"tree/helper": "helper", "first/helper": "helper", "first/other": "other"}
    found, said = hidden(tmp_path, copy)
    assert found == ["first/helper"]
    assert said == "roslab: left out: src/first/helper, for src/tree/helper is a package called helper, too\n"


@pytest.mark.parametrize(
    ("packages", "markers", "found"),
    [
        ({"tree": "a", "first": "b", "second": "c"}, (), []),
        ({"first/x": "b", "second/y": "b"}, (), ["second/y"]),
        ({"tree/old": "a", "first": "a"}, ("tree/old",), []),  # the repository itself hides its copy
        ({"tree": "a", "tree/deep": "b", "first": "b"}, (), []),  # no tool finds a package inside another
        ({"tree": "a", "first/one": "a", "first/two": "b"}, ("first/one",), []),
        ({"first/ros1": "b", "first/ros2": "b"}, (), []),  # its author knows which of them is meant
        ({}, (), []),
    ],
)
def test_what_is_hidden(tmp_path: Path, packages: dict[str, str], markers: tuple[str, ...], found: list[str]) -> None:
    assert hidden(tmp_path, packages, *markers)[0] == found


def test_a_clone_is_not_its_own_double_by_another_spelling_of_its_path(tmp_path: Path) -> None:
    (tmp_path / "ws/src/new/mine").mkdir(parents=True)
    (tmp_path / "ws/src/new/mine/package.xml").write_text("<package><name>mine</name></package>")
    words = ["leave-out-doubles", "--beside", f"{tmp_path}/ws/../ws/src", "src/new"]
    subprocess.run(words, cwd=tmp_path / "ws", capture_output=True, check=True)
    assert not list(tmp_path.rglob("CATKIN_IGNORE"))


def test_what_will_lie_in_the_workspace_counts(tmp_path: Path) -> None:
    for folder in ("ws/src/new/mine", "ws/src/new/other", "manifests/mine"):
        (tmp_path / folder).mkdir(parents=True)
        name = folder.rpartition("/")[2]
        (tmp_path / folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
    words = ["leave-out-doubles", "--beside", str(tmp_path / "manifests"), "src/new"]
    subprocess.run(words, cwd=tmp_path / "ws", capture_output=True, check=True)
    assert [file.parent.name for file in tmp_path.rglob("CATKIN_IGNORE")] == ["mine"]
