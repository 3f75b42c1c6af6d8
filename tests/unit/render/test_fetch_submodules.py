"""The script that fetches submodules: where one cannot be had, the others are there."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.config.model import Source
from roslab.render import image_scripts
from roslab.render.layers.system import clone

SCRIPT = Path(image_scripts.__path__[0]) / "fetch-submodules.sh"


def _git(folder: Path, *words: str) -> None:
    identity = ("-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "protocol.file.allow=always")
    subprocess.run(["git", *identity, *words], cwd=folder, capture_output=True, check=True)


def _made(root: Path, name: str, *submodules: str) -> Path:
    folder = root / name
    folder.mkdir()
    _git(folder, "init", "--quiet")
    (folder / "here.txt").write_text(name, encoding="utf-8")
    for each in submodules:
        _git(folder, "submodule", "add", "--quiet", (root / each).as_uri(), f"deps/{each}")
    _git(folder, "add", ".")
    _git(folder, "commit", "--quiet", "--message", name)
    return folder


@pytest.mark.parametrize(
    ("gone", "there", "said"),
    [
        ("", ["json", "json/leaf", "media", "deep", "deep/leaf"], []),
        ("media", ["json", "json/leaf", "deep", "deep/leaf"], ["clone/deps/media"]),
        ("leaf", ["json", "media", "deep"], ["deep/deps/leaf", "json/deps/leaf"]),
    ],
)
def test_what_can_be_had_is_there(tmp_path: Path, gone: str, there: list[str], said: list[str]) -> None:
    _made(tmp_path, "leaf")
    _made(tmp_path, "media")
    _made(tmp_path, "json", "leaf")
    _made(tmp_path, "deep", "leaf")
    folder = _made(tmp_path, "all", "media", "json", "deep")
    with (folder / ".gitmodules").open("a", encoding="utf-8") as file:
        file.write('[submodule "old"]\npath = old\nurl = https://example.org/of/a/folder/that/was/removed\n')
    _git(folder, "commit", "--all", "--quiet", "--message", "A line that was left")
    _git(tmp_path, "clone", "--quiet", (tmp_path / "all").as_uri(), "clone")
    if gone:
        (tmp_path / gone).rename(tmp_path / "private")
    settings = {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "protocol.file.allow", "GIT_CONFIG_VALUE_0": "always"}
    ran = subprocess.run(
        ["bash", SCRIPT, tmp_path / "clone"],
        capture_output=True,
        text=True,
        check=True,
        env={"PATH": "/usr/bin:/bin:/usr/local/bin", "HOME": str(tmp_path), **settings},
    )
    found = [name for name in ("json", "json/leaf", "media", "deep", "deep/leaf") if _has(tmp_path / "clone", name)]
    assert found == there
    told = [
        line.partition("left out: ")[2].partition(" cannot")[0]
        for line in ran.stdout.splitlines()
        if "left out" in line
    ]
    assert sorted(told) == said


def _has(clone: Path, name: str) -> bool:
    return (clone / "deps" / name.replace("/", "/deps/") / "here.txt").exists()


def test_a_clone_without_submodules_stays_as_it_is(tmp_path: Path) -> None:
    ran = subprocess.run(["bash", SCRIPT, _made(tmp_path, "plain")], capture_output=True, text=True, check=True)
    assert (ran.stdout, ran.stderr) == ("", "")


@pytest.mark.parametrize(
    ("source", "whole"),
    [
        (Source(name="ceres", repo="https://example.org/ceres.git"), True),
        (Source(name="ceres", repo="https://example.org/ceres.git", unread=True), False),
        (Source(name="ceres", repo="https://example.org/ceres.git", tabled=True), False),
        (Source(name="ceres", repo="https://example.org/ceres.git", unasked=True), False),
    ],
)
def test_an_authors_own_source_needs_all_of_them(source: Source, whole: bool) -> None:
    last = clone(source, "/tmp/sources/ceres")[-1]
    assert last == (
        "git -C /tmp/sources/ceres submodule update --init --recursive"
        if whole
        else "fetch-submodules /tmp/sources/ceres"
    )
