"""Writing: all or nothing, never over an author's file, nothing half-written."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from roslab import files
from roslab.errors import ConfigurationError, RefusedError
from roslab.files import Written, replace_with_backup, write_all, write_configuration
from roslab.render.output import MARKER, OutputFile, generated

OURS = f"#!/bin/sh\n# {MARKER}.\n"


def output(path: str, text: str = OURS, *, executable: bool = False) -> OutputFile:
    return OutputFile(path=path, text=text, executable=executable)


def tree(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_files_are_made_with_their_folder(tmp_path: Path) -> None:
    written = write_all([output("a", "ä\n"), output("sub/run.sh", executable=True)], tmp_path / "deep" / "out")
    assert [str(entry) for entry in written] == ["created   a", "created   sub/run.sh"]
    assert tree(tmp_path) == {"deep/out/a": "ä\n".encode(), "deep/out/sub/run.sh": OURS.encode()}
    assert os.access(tmp_path / "deep/out/sub/run.sh", os.X_OK)
    assert not os.access(tmp_path / "deep/out/a", os.X_OK)


def test_the_umask_decides_who_may_read(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        write_all([output("a"), output("b", executable=True)], tmp_path)
    finally:
        os.umask(before)
    assert [stat.S_IMODE((tmp_path / name).stat().st_mode) for name in "ab"] == [0o600, 0o700]


def test_the_same_file_is_left_alone(tmp_path: Path) -> None:
    write_all([output("a")], tmp_path)
    before = (tmp_path / "a").stat()
    assert write_all([output("a")], tmp_path) == (Written(path="a", action="unchanged"),)
    after = (tmp_path / "a").stat()
    assert (before.st_ino, before.st_mtime_ns) == (after.st_ino, after.st_mtime_ns)


def test_a_program_that_lost_its_mode_is_written_again(tmp_path: Path) -> None:
    write_all([output("a", executable=True)], tmp_path)
    (tmp_path / "a").chmod(0o644)
    (entry,) = write_all([output("a", executable=True)], tmp_path, force=True)
    assert entry.action == "replaced"
    assert os.access(tmp_path / "a", os.X_OK)


def test_force_replaces_its_own_files_only(tmp_path: Path) -> None:
    write_all([output("a")], tmp_path)
    newer = output("a", OURS + "new\n")
    with pytest.raises(RefusedError, match="a: roslab wrote it earlier"):
        write_all([newer], tmp_path)
    assert (tmp_path / "a").read_text() == OURS
    assert write_all([newer, output("b")], tmp_path, force=True)[0].action == "replaced"
    assert (tmp_path / "a").read_text() == OURS + "new\n"
    assert sorted(tree(tmp_path)) == ["a", "b"], "no temporary file stays"


@pytest.mark.parametrize("force", [False, True])
def test_every_file_of_the_authors_is_named_and_none_is_touched(tmp_path: Path, force: bool) -> None:
    (tmp_path / "a").write_text("mine\n")
    (tmp_path / "b").write_text("\n" * 10 + OURS)  # a mark further down is a quotation
    (tmp_path / "c").mkdir()
    (tmp_path / "d").symlink_to("a")
    (tmp_path / "e").symlink_to("nowhere")
    os.mkfifo(tmp_path / "f")
    before = tree(tmp_path)
    with pytest.raises(RefusedError) as caught:
        write_all([output(name) for name in "abcdefg"], tmp_path, force=force)
    assert [(p.file, p.message) for p in caught.value.problems] == [
        ("a", "roslab did not write it"),
        ("b", "roslab did not write it"),
        ("c", "it is a folder"),
        ("d", "it is a link, and roslab does not write through links"),
        ("e", "it is a link, and roslab does not write through links"),
        ("f", "it is not a regular file"),
    ]
    assert caught.value.exit_code == 4
    assert tree(tmp_path) == before


def test_a_folder_on_the_way_that_is_a_link(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "sub").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "out" / "file").write_text("x")
    with pytest.raises(RefusedError):
        write_all([output("sub/a")], tmp_path / "out", force=True)
    with pytest.raises(RefusedError):
        write_all([output("file/a")], tmp_path / "out", force=True)
    assert not list((tmp_path / "elsewhere").iterdir())


@pytest.mark.parametrize("path", ["../a", "/tmp/a", "", ".", "a/../../b", "./a", "a//b"])
def test_no_file_leads_out(tmp_path: Path, path: str) -> None:
    with pytest.raises(RefusedError, match="leads out of the folder"):
        write_all([output(path)], tmp_path / "out", force=True)
    assert not (tmp_path / "out").exists()


def test_the_folder_is_a_file(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("x")
    with pytest.raises(ConfigurationError, match="is a file, not a folder"):
        write_all([output("a")], tmp_path / "out")
    with pytest.raises(ConfigurationError, match=r"cannot write .*Not a directory"):
        write_all([output("a")], tmp_path / "out" / "deeper")


def test_the_disk_is_full_half_way(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not even a folder stays; what was there is there again."""
    write_all([output("a")], tmp_path)
    write = files._write

    def full(path: Path, content: bytes, *, executable: bool) -> None:
        write(path, content[:3], executable=executable)
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files, "_write", full)
    with pytest.raises(ConfigurationError, match=r"No space left on device .*--output DIR") as caught:
        write_all([output("a", OURS + "new"), output("b")], tmp_path, force=True)
    assert caught.value.exit_code == 2
    with pytest.raises(ConfigurationError):
        write_all([output("x/b")], tmp_path / "new" / "folder")
    assert tree(tmp_path) == {"a": OURS.encode()}
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


@pytest.mark.parametrize("links", [True, False])
@pytest.mark.parametrize("error", [OSError(5, "Input/output error"), KeyboardInterrupt()])
def test_what_was_done_is_undone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: BaseException, links: bool
) -> None:
    write_all([output("a"), output("b")], tmp_path)
    replace = Path.replace

    def fail(self: Path, target: Path) -> Path:
        if target.name == "c":
            raise error
        return replace(self, target)

    def no_links(self: Path, target: Path) -> None:
        raise OSError(1, "Operation not permitted")

    monkeypatch.setattr(Path, "replace", fail)
    if not links:
        monkeypatch.setattr(Path, "hardlink_to", no_links)
    before = tree(tmp_path)
    with pytest.raises((ConfigurationError, KeyboardInterrupt)):
        write_all([output(name, OURS + "new") for name in ("a", "b", "c")], tmp_path, force=True)
    assert tree(tmp_path) == before


@pytest.mark.skipif(os.getuid() == 0, reason="root may write everywhere")
def test_a_folder_that_may_not_be_written(tmp_path: Path) -> None:
    tmp_path.chmod(0o555)
    try:
        with pytest.raises(ConfigurationError, match="Permission denied"):
            write_all([output("a")], tmp_path)
    finally:
        tmp_path.chmod(0o755)


def test_a_file_system_that_cannot_be_written() -> None:
    with pytest.raises(ConfigurationError, match="cannot write /proc/roslab: "):
        write_all([output("a")], "/proc/roslab")


def test_a_name_that_is_no_name() -> None:
    with pytest.raises(ConfigurationError):
        write_all([output("a")], "/tmp/" + "x" * 300)


def test_text_that_is_no_utf_8(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError, match="cannot be written as UTF-8"):
        write_all([output("a", "\udcff")], tmp_path)


@pytest.mark.parametrize(
    ("name", "content", "ours"),
    [
        ("Dockerfile", b"# Generated by roslab. x\nFROM a\n", True),
        ("run.sh", b"#!/usr/bin/env bash\n# Generated by roslab\n", True),
        ("run.sh", b"echo Generated by roslab\n", False),
        ("a.ipynb", b'{"metadata": {"roslab": {"generated": "Generated by roslab from README.md"}}}', True),
        ("a.ipynb", b'{"metadata": {}, "cells": [{"source": "# Generated by roslab"}]}', False),
        ("a.ipynb", b"# Generated by roslab\n", False),
        ("a.ipynb", b"[" * 100_000, False),
        ("a.ipynb", b"\xff\xfe", False),
        ("a.ipynb", b"[]", False),
    ],
)
def test_the_mark(name: str, content: bytes, ours: bool) -> None:
    assert generated(name, content) is ours


def test_a_backup_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "roslab.yaml"
    path.write_text("old\n")
    path.chmod(0o640)
    assert replace_with_backup(path, "new\n") == tmp_path / "roslab.yaml.old"
    assert tree(tmp_path) == {"roslab.yaml": b"new\n", "roslab.yaml.old": b"old\n"}
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    with pytest.raises(RefusedError, match=r"roslab.yaml.old already exists"):
        replace_with_backup(path, "newer\n")
    assert path.read_text() == "new\n"


def test_a_file_that_cannot_be_changed_is_written_nowhere_else(tmp_path: Path) -> None:
    """It has one place: no option names another."""
    with pytest.raises(ConfigurationError, match="cannot write") as error:
        write_configuration(tmp_path / "missing" / "roslab.yaml", None, "new\n")
    assert "--output" not in str(error.value)
    assert "its own folder, which you must be allowed to write" in str(error.value)


def test_no_backup_of_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("x")
    (tmp_path / "link").symlink_to("real")
    with pytest.raises(RefusedError):
        replace_with_backup(tmp_path / "link", "new")
    with pytest.raises(ConfigurationError):
        replace_with_backup(tmp_path / "missing", "new")
    assert tree(tmp_path) == {"real": b"x", "link": b"x"}


def test_a_file_whose_comments_have_slashes_is_known_again() -> None:
    assert generated("devcontainer.json", b'// Generated by roslab\n{"name": "x"}\n')
    assert not generated("devcontainer.json", b'{"name": "Generated by roslab"}\n')
