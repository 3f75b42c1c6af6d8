"""The reader of a checkout: what it lists, what it never touches."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError, NothingToBuildError
from roslab.repository.checkout import MAX_TEXT, Repository, printable


def write(path: Path, text: str | bytes = "") -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def test_lists_regular_files_sorted_and_skips_version_control(tmp_path: Path) -> None:
    for name in ("b.txt", "a/z.cpp", ".git/config", "node_modules/x.js", "a/b/package.xml"):
        write(tmp_path / name, "x")
    repository = Repository.open(tmp_path)
    assert [file.path for file in repository.files] == ["a/b/package.xml", "a/z.cpp", "b.txt"]
    assert repository.folders == {"", "a", "a/b"}
    assert [file.path for file in repository.named("PACKAGE.XML")] == ["a/b/package.xml"]
    assert [file.path for file in repository.suffixed(".CPP", ".txt")] == ["a/z.cpp", "b.txt"]


def test_what_an_editor_keeps_of_a_file_is_none_without_a_suffix(tmp_path: Path) -> None:
    for name in ("install", "install~", "page.md", "page.md~", ".bashrc~"):
        write(tmp_path / name)
    repository = Repository.open(tmp_path)
    assert [file.path for file in repository.suffixed("")] == ["install"]
    assert [file.path for file in repository.suffixed(".md")] == ["page.md"]


def test_what_is_made_of_a_repository_is_made_once_and_anew_without_files(tmp_path: Path) -> None:
    write(tmp_path / "a.txt")
    write(tmp_path / "b.txt")
    asked: list[Repository] = []

    def names(repository: Repository) -> tuple[str, ...]:
        asked.append(repository)
        return tuple(file.name for file in repository.files)

    repository = Repository.open(tmp_path)
    assert repository.once(names) == repository.once(names) == ("a.txt", "b.txt")
    assert repository.leaving_out({"a.txt"}).once(names) == ("b.txt",)
    assert len(asked) == 2


def test_a_link_out_of_the_tree_is_named_and_never_read(tmp_path: Path) -> None:
    secret = write(tmp_path / "outside/secret.txt", "token")
    root = tmp_path / "tree"
    write(root / "real.txt", "inside")
    (root / "in.txt").symlink_to("real.txt")
    (root / "out.txt").symlink_to(secret)
    (root / "out").symlink_to(secret.parent)
    (root / "dangling").symlink_to("nowhere")
    (root / "loop").symlink_to(".")
    repository = Repository.open(root)
    assert [file.path for file in repository.files] == ["in.txt", "real.txt"]
    assert repository.read("in.txt") == "inside"
    assert repository.read("out.txt") == ""
    assert repository.read("../outside/secret.txt") == ""
    assert repository.listing.outside == ("dangling", "out", "out.txt")


def test_links_in_circles_end(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    write(tmp_path / "c/file", "x")
    (tmp_path / "c/up").symlink_to("..")
    assert [file.path for file in Repository.open(tmp_path).files] == ["c/file"]


def test_reads_at_most_the_cap_of_a_huge_file(tmp_path: Path) -> None:
    with (tmp_path / "requirements.txt").open("wb") as stream:
        stream.write(b"numpy\n" * 1000)
        stream.truncate(2 * 1024**3)  # sparse: takes no room
    repository = Repository.open(tmp_path)
    assert len(repository.read_bytes("requirements.txt")) == MAX_TEXT


def test_a_short_look_hides_nothing_from_the_next_reader(tmp_path: Path) -> None:
    write(tmp_path / "file", "abcdef")
    repository = Repository.open(tmp_path)
    assert repository.read("file", limit=3) == "abc"
    assert repository.read("file") == "abcdef"
    assert repository.read("file", limit=3) == "abcdef", "what is kept already costs nothing"


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"\xef\xbb\xbfa\r\nb\rc", "a\nb\nc"),
        ("numpy\n".encode("utf-16"), "numpy\n"),
        (b"caf\xe9", "caf\ufffd"),
        (b"\x7fELF\0\0", ""),
    ],
)
def test_decodes_what_editors_write(tmp_path: Path, data: bytes, text: str) -> None:
    write(tmp_path / "file", data)
    assert Repository.open(tmp_path).read("file") == text


def test_names_that_are_no_utf8(tmp_path: Path) -> None:
    os.close(os.open(os.fsencode(tmp_path) + b"/\xff\n.txt", os.O_CREAT | os.O_WRONLY))
    (file,) = Repository.open(tmp_path).files
    assert printable(file.path) == "\\udcff\\n.txt"


def test_a_pipe_is_no_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "requirements.txt")
    write(tmp_path / "a")
    assert [file.path for file in Repository.open(tmp_path).files] == ["a"]


def test_branch_and_origin_come_from_git_without_running_it(tmp_path: Path) -> None:
    write(tmp_path / ".git/HEAD", "ref: refs/heads/noetic-devel\n")
    write(tmp_path / ".git/config", '[remote "origin"]\n\turl = https://github.com/someone/paper.git\n[branch "x"]\n')
    write(tmp_path / "a")
    repository = Repository.open(tmp_path)
    assert repository.branch == "noetic-devel"
    assert repository.origin == "https://github.com/someone/paper.git"
    assert Repository.open(tmp_path, branch="humble").branch == "humble"


def test_a_detached_head_has_no_branch(tmp_path: Path) -> None:
    write(tmp_path / ".git/HEAD", "0" * 40)
    assert Repository.open(tmp_path).branch is None


@pytest.mark.parametrize("name", ["missing", "file"])
def test_what_is_no_directory_is_refused(tmp_path: Path, name: str) -> None:
    write(tmp_path / "file")
    with pytest.raises(ConfigurationError, match="not a directory"):
        Repository.open(tmp_path / name)


def test_an_empty_directory_holds_nothing_to_build(tmp_path: Path) -> None:
    with pytest.raises(NothingToBuildError, match="is empty"):
        Repository.open(tmp_path)
