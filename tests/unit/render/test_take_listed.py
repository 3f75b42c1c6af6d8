"""What the repository of a workspace lists is cloned, in place of what is there under the same name."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")


def _git(folder: Path, *words: str, day: str = "2019-05-20") -> str:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    dates = {"GIT_AUTHOR_DATE": f"{day}T12:00:00Z", "GIT_COMMITTER_DATE": f"{day}T12:00:00Z"}
    allowed = ("-c", "protocol.file.allow=always")
    answer = subprocess.run(
        ["git", *identity, *allowed, *words],
        cwd=folder,
        env=os.environ | dates,
        capture_output=True,
        text=True,
        check=True,
    )
    return answer.stdout.strip()


def _commit(folder: Path, name: str, text: str, day: str = "2019-05-20") -> str:
    folder.mkdir(exist_ok=True)
    if not (folder / ".git").exists():
        _git(folder, "init", "--quiet")
    (folder / name).write_text(text)
    _git(folder, "add", ".")
    _git(folder, "commit", "--quiet", "--message", "more", day=day)
    return _git(folder, "rev-parse", "HEAD")


def _run(tmp_path: Path, *words: str) -> tuple[str, dict[str, str]]:
    """Return what the script says, and what each clone below the workspace has in its file ``a``."""
    rosdep = tmp_path / "scripts/rosdep"
    rosdep.write_text(f"#!{sys.executable}\n")
    rosdep.chmod(0o755)
    remote = (tmp_path / "lab_ws").as_uri()
    command = ["take-listed", *words, remote, f"{tmp_path}/ws/src/lab_ws"]
    environment = os.environ | {"ROS_DISTRO": "melodic"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert "Traceback" not in done.stderr
    source = tmp_path / "ws/src"
    return done.stdout, {str(file.parent.relative_to(source)): file.read_text() for file in source.rglob("a")}


def test_forks_take_the_place_of_what_is_there(tmp_path: Path) -> None:
    for name in ("maps", "extra", "lab_planner"):
        _commit(tmp_path / name, "a", f"fork of {name}\n")
    (tmp_path / "ws/src").mkdir(parents=True)
    _commit(tmp_path / "ws/src/maps", "a", "upstream\n")
    (tmp_path / "ws/src/maps/.git/roslab-plain").write_text("maps\n")
    rows = [("src/maps", "maps", "main"), ("extra/", "extra", ""), ("planner", "lab_planner", ""), ("x", "gone", "")]
    text = "".join(
        f"- git:\n    local-name: {local}\n    uri: {(tmp_path / name).as_uri()}\n"
        + f"    version: {ref}\n" * bool(ref)
        for local, name, ref in rows
    )
    _commit(tmp_path / "lab_ws", "packages_https.rosinstall", text)
    said, found = _run(tmp_path, "--but", "lab_planner")
    assert found == {"maps": "fork of maps\n", "lab_ws/extra": "fork of extra\n"}
    assert (tmp_path / "ws/src/maps/.git/roslab-plain").read_text() == "maps\n", "it is compiled before the workspace"
    assert "roslab: maps is taken as" in said
    assert "gone , which" in said


def test_what_cannot_be_cloned_leaves_what_is_there(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    _commit(tmp_path / "ws/src/maps", "a", "upstream\n")
    listed = f"repositories:\n  maps:\n    type: git\n    url: {(tmp_path / 'gone').as_uri()}\n    version: main\n"
    _commit(tmp_path / "lab_ws", "lab.repos", listed)
    assert _run(tmp_path)[1] == {"maps": "upstream\n"}


def test_a_workspace_that_is_gone_changes_nothing(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    said, found = _run(tmp_path)
    assert "cannot be cloned, and what it lists is not known" in said
    assert found == {}


def test_branches_of_the_distribution_days_and_submodules(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    for name in ("maps", "tools"):
        _commit(tmp_path / name, "a", "old\n")
    recorded = _git(tmp_path / "tools", "rev-parse", "HEAD")
    listed = f"- git: {{local-name: maps, uri: '{(tmp_path / 'maps').as_uri()}'}}\n"
    workspace = tmp_path / "lab_ws"
    _commit(workspace, "README", "a workspace\n")
    _git(workspace, "checkout", "--quiet", "-b", "melodic-devel")
    _git(workspace, "submodule", "--quiet", "add", (tmp_path / "tools").as_uri(), "src/tools")
    _commit(workspace, "a.rosinstall", listed)
    _git(workspace, "checkout", "--quiet", "main")
    for name in ("maps", "tools"):
        _commit(tmp_path / name, "a", "new\n", day="2022-01-01")
    _, found = _run(tmp_path, "--before", "2020-01-01")
    assert found == {"lab_ws/maps": "old\n", "lab_ws/tools": "old\n"}
    assert _git(tmp_path / "ws/src/lab_ws/tools", "rev-parse", "HEAD") == recorded


@pytest.mark.parametrize(
    "text",
    [
        "- [\n",
        "- git: 5\n- 7\n",
        "repositories: [1]\n",
        "",
        "sources: [7]\ngroups: [{name: [a]}]\n",
        "- git: {local-name: ../x, uri: -u}\n",
    ],
)
def test_a_list_that_is_none(tmp_path: Path, text: str) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    _commit(tmp_path / "lab_ws", "a.rosinstall", text or "\n")
    assert _run(tmp_path)[1] == {}


GITMAN = """\
sources:
  - {{repo: {maps}, name: maps, rev: main, type: git}}
  - {{repo: {extra}, rev: main}}
  - {{repo: {tools}, name: tools, rev: main, type: git}}
sources_locked:
  - {{repo: {maps}, name: maps, rev: {locked}, type: git}}
groups:
  - {{name: core, members: [maps, more]}}
  - {{name: more, members: [extra, core]}}
"""


@pytest.mark.parametrize(
    ("more", "names"),
    [
        ("default_group: core\n", {"maps", "extra"}),
        ("default_group: ''\n", {"maps", "extra", "tools"}),
        ("default_group: [1]\n", set()),
    ],
)
@pytest.mark.parametrize("file", ["gitman.yml", ".gitman.yml"])
def test_of_gitman_it_is_the_default_group_at_what_is_locked(
    tmp_path: Path, file: str, more: str, names: set[str]
) -> None:
    addresses = {name: (tmp_path / name).as_uri() for name in ("maps", "extra", "tools")}
    locked = {name: _commit(tmp_path / name, "a", "first\n") for name in addresses}["maps"]
    _commit(tmp_path / "maps", "a", "second\n")
    at = _commit(tmp_path / "lab_ws", file, GITMAN.format(**addresses, locked=locked) + more)
    _commit(tmp_path / "lab_ws", file, "sources: []\n")
    (tmp_path / "ws/src").mkdir(parents=True)
    _, found = _run(tmp_path, "--branch", at)
    assert found == {f"lab_ws/{name}": "first\n" for name in names}


def test_of_the_submodules_of_what_is_listed_those_that_can_be_had_are_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for key, value in {"COUNT": "1", "KEY_0": "protocol.file.allow", "VALUE_0": "always"}.items():
        monkeypatch.setenv(f"GIT_CONFIG_{key}", value)
    for name in ("json", "private", "maps"):
        _commit(tmp_path / name, "a", f"{name}\n")
    for name in ("private", "json"):
        _git(tmp_path / "maps", "submodule", "--quiet", "add", (tmp_path / name).as_uri(), name)
    _commit(tmp_path / "maps", "b", "more\n")
    _commit(tmp_path / "lab_ws", "a.repos", f"repositories: {{maps: {{url: {(tmp_path / 'maps').as_uri()}}}}}\n")
    (tmp_path / "private").rename(tmp_path / "gone")
    (tmp_path / "ws/src").mkdir(parents=True)
    said, found = _run(tmp_path)
    assert found == {"lab_ws/maps": "maps\n", "lab_ws/maps/json": "json\n"}
    assert "roslab: left out: maps/private cannot be cloned" in said
