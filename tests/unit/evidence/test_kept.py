"""Evidence is kept for as long as nothing has changed that it comes from, and nothing else is taken for it."""

from __future__ import annotations

import marshal
import os
import pickle
import subprocess
import sys
import zlib
from collections.abc import Callable
from functools import partial
from importlib.machinery import ModuleSpec
from pathlib import Path

import pytest

from roslab.evidence import kept
from roslab.evidence.facts import Evidence
from roslab.evidence.gather import gather
from roslab.repository import git
from roslab.repository.checkout import Repository
from roslab.values import kept_trees
from roslab.values.kept_trees import KeptTree
from trees import commit, tree_of

FILES = {
    "package.xml": "<package format='3'><name>demo</name><depend>tf2</depend></package>",
    "README.md": "# Demo\n\n```\npip install numpy==1.21\n```\n",
    "main.py": "import numpy\n",
}
GATHER, READ = kept._gather, git._read


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder in which trees are kept, also those that were written just now."""
    cache = tmp_path / "__pycache__"
    cache.mkdir()
    spec = ModuleSpec("kept", None)
    spec.cached = str(cache / "kept.pyc")
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(kept_trees, "_begun", True)
    monkeypatch.setattr(kept, "RACY", -(10**18))
    monkeypatch.setattr(kept, "KeptTree", lambda _, path: KeptTree(spec, path))
    return cache


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    tree_of(tmp_path / "tree", FILES)
    return tmp_path / "tree"


def is_read(tree: Path, monkeypatch: pytest.MonkeyPatch, **named: str) -> bool:
    """Ask for the evidence of a tree; tell whether it was read, and see to it that it is what is read."""
    read: list[Repository] = []

    def noted(repository: Repository) -> Evidence:
        read.append(repository)
        return GATHER(repository)

    with monkeypatch.context() as patch:
        patch.setattr(kept, "_gather", noted)
        found = kept.evidence_of(Repository.open(tree, **named))  # type: ignore[arg-type]
    assert found == gather(Repository.open(tree, **named))  # type: ignore[arg-type]
    return bool(read)


def test_an_unchanged_tree_is_read_once(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert [is_read(tree, monkeypatch) for _ in range(3)] == [True, False, False]
    assert [path.stat().st_mode & 0o777 for path in folder.iterdir()] == [0o600]


def in_place(text: str, tree: Path) -> None:
    """Write as many bytes as there were, and give the file the date that it had."""
    file = tree / "README.md"
    before = file.stat()
    file.write_text(text, encoding="utf-8")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert (file.stat().st_size, file.stat().st_mtime_ns) == (before.st_size, before.st_mtime_ns)


def replaced(tree: Path) -> None:
    (tree / "main.py").replace(tree / "other.py")


CHANGES: dict[str, Callable[[Path], object]] = {
    "of the same size and date": partial(in_place, FILES["README.md"].replace("1.21", "1.22")),
    "of another size": lambda tree: (tree / "main.py").write_text("import scipy, numpy\n", encoding="utf-8"),
    "a new file": lambda tree: (tree / "requirements.txt").write_text("torch\n", encoding="utf-8"),
    "a new folder": lambda tree: (tree / "empty").mkdir(),
    "a file less": lambda tree: (tree / "main.py").unlink(),
    "another name": replaced,
    "a link": lambda tree: (tree / "link.py").symlink_to("main.py"),
    "a link out of the tree": lambda tree: (tree / "link.py").symlink_to("/nowhere"),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_a_change_is_seen(
    change: Callable[[Path], object], folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    is_read(tree, monkeypatch)
    change(tree)
    assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, False]


def test_a_link_to_another_file_is_seen(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tree / "a.txt").write_text("numpy\n", encoding="utf-8")
    (tree / "b.txt").write_text("torch\n", encoding="utf-8")
    link = tree / "requirements.txt"
    for target in ("a.txt", "b.txt"):
        link.unlink(missing_ok=True)
        link.symlink_to(target)
        assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, False]


def test_what_git_tells_is_asked_again(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def told() -> list[bool]:
        return [is_read(tree, monkeypatch) for _ in range(2)]

    assert told() == [True, False]
    commit(tree, "2021-03-01")
    assert told() == [True, False]
    (tree / ".git" / "HEAD").write_text("ref: refs/heads/noetic-devel\n", encoding="utf-8")
    assert told() == [True, False]
    with (tree / ".git" / "config").open("a", encoding="utf-8") as stream:
        stream.write('[remote "origin"]\n\turl = https://github.com/someone/paper.git\n')
    assert told() == [True, False]
    assert [is_read(tree, monkeypatch, branch="humble") for _ in range(2)] == [True, False]


def test_a_commit_is_not_asked_again(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    commit(tree, "2021-03-01")
    asked: list[str] = []

    def read(folder: str, *command: str) -> str:
        asked.append(command[0])
        return str(READ(folder, *command))

    monkeypatch.setattr(git, "_read", read)
    is_read(tree, monkeypatch)
    repository = Repository.open(tree)
    asked.clear()
    assert kept.evidence_of(repository).worked_on[0].value == "2021-03-01"
    assert not asked


@pytest.mark.parametrize("packed", [False, True])
def test_another_commit_of_the_branch_is_seen(
    packed: bool, folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    commit(tree, "2021-03-01")
    for day in ("2021-03-01", "2022-04-02", "2023-05-03"):
        when = dict.fromkeys(("GIT_AUTHOR_DATE", "GIT_COMMITTER_DATE"), f"{day}T12:00:00Z")
        settings = ("-c", "user.name=a", "-c", "user.email=a@example.org")
        empty = ("commit", "--quiet", "--allow-empty", "--message", day)
        subprocess.run(["git", "-C", tree, *settings, *empty], check=True, env={**os.environ, **when})
        if packed:
            subprocess.run(["git", "-C", tree, "pack-refs", "--all"], check=True)
        days = [kept.evidence_of(Repository.open(tree)).worked_on[0].value for _ in range(2)]
        assert days == [day, day]
        assert not is_read(tree, monkeypatch)


@pytest.mark.parametrize(
    ("head", "branch"),
    [
        ("ref: ../../main.py\n", ""),
        ("ref: refs/../config\n", ""),
        ("ref: refs/heads/absent\n", ""),
        ("ref: refs/heads/other\n", "ref: refs/heads/main\n"),
        ("nothing\n", ""),
        ("ref: refs/heads/ma\0in\n", ""),
    ],
)
def test_of_a_head_that_names_no_commit_nothing_is_known(
    head: str, branch: str, folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    commit(tree, "2021-03-01")
    assert Repository.open(tree).checkout
    (tree / ".git" / "HEAD").write_text(head, encoding="utf-8")
    if branch:
        (tree / ".git" / "refs" / "heads" / "other").write_text(branch, encoding="utf-8")
    assert Repository.open(tree).checkout is None
    assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, False]


def test_a_branch_that_is_no_file_is_not_waited_for(tree: Path) -> None:
    branch = tree / ".git" / "refs" / "heads" / "main"
    branch.parent.mkdir(parents=True)
    (tree / ".git" / "HEAD").write_text("ref: refs/heads/main\n", encoding="utf-8")
    (tree / ".git" / "commondir").write_text("else\0where\n", encoding="utf-8")
    os.mkfifo(branch)
    assert Repository.open(tree).checkout is None
    branch.unlink()
    branch.symlink_to("/dev/zero")
    assert Repository.open(tree).checkout is None


def test_a_file_that_points_to_no_folder_of_git_is_none(tree: Path) -> None:
    (tree / ".git").write_text("gitdir: else\0where\n", encoding="utf-8")
    assert Repository.open(tree).git_folder is None


def test_another_program_reads_anew(folder: Path, tree: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    table = tmp_path / "table.csv"
    table.write_text("a\n", encoding="utf-8")
    monkeypatch.setattr(kept, "used", {str(table)})
    is_read(tree, monkeypatch)
    assert not is_read(tree, monkeypatch)
    table.write_text("b\n", encoding="utf-8")
    assert is_read(tree, monkeypatch)
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path)])
    assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, False]
    (tmp_path / "a-library").mkdir()
    assert is_read(tree, monkeypatch)


def test_what_was_written_just_now_is_not_trusted(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept, "RACY", 2_000_000_000)
    assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, True]
    assert not list(folder.iterdir())


def test_of_a_large_tree_nothing_is_kept(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept, "MOST_FILES", 2)
    assert is_read(tree, monkeypatch)
    assert not list(folder.iterdir())


def changed(file: Path, change: Callable[[bytes], bytes]) -> None:
    file.write_bytes(change(file.read_bytes()))


def checked(content: bytes) -> bytes:
    return zlib.crc32(content).to_bytes(4, "little") + content


def linked(file: Path) -> None:
    file.replace(file.with_suffix(".elsewhere"))
    file.symlink_to(file.with_suffix(".elsewhere"))


def unreadable(file: Path) -> None:
    file.unlink()
    file.mkdir()


class Hostile:
    """Would make a folder, were it made."""

    def __reduce__(self) -> tuple[Callable[[str], None], tuple[str]]:
        return os.mkdir, ("hostile",)


def in_place_of_evidence(whole: bytes, pickled: bytes) -> bytes:
    end = 12 + int.from_bytes(whole[4:12], "little")
    return checked(whole[4:end] + pickled)


def called(module: str, name: str) -> bytes:
    """Return what has a class of a module make a folder; ``pickle`` itself would not write it."""
    words = [b"\x8c" + bytes([len(word)]) + word.encode() for word in (module, name, "mkdir", "hostile")]
    return b"\x80\x04" + words[0] + words[1] + b"\x93]" + words[2] + b"a" + words[3] + b"a\x85R."


DAMAGES: dict[str, Callable[[Path], object]] = {
    "empty": partial(changed, change=lambda _: b""),
    "foreign": partial(changed, change=lambda _: b"nothing of this kind"),
    "cut off": partial(changed, change=lambda whole: whole[:-1]),
    "overwritten": partial(changed, change=lambda whole: whole[:-9] + bytes(9)),
    "of another version": partial(changed, change=lambda _: checked(bytes(8) + marshal.dumps("state"))),
    "of foreign classes": partial(changed, change=partial(in_place_of_evidence, pickled=pickle.dumps(({}, Hostile())))),
    "of a class behind ours": partial(
        changed, change=partial(in_place_of_evidence, pickled=called("roslab.repository.fetching", "subprocess.Popen"))
    ),
    "of a class that is gone": partial(
        changed, change=partial(in_place_of_evidence, pickled=called("roslab.evidence.facts", "Gone"))
    ),
    "of a module that is gone": partial(
        changed, change=partial(in_place_of_evidence, pickled=called("roslab.gone", "Gone"))
    ),
    "of something else": partial(changed, change=partial(in_place_of_evidence, pickled=pickle.dumps(1))),
    "of nothing": partial(changed, change=partial(in_place_of_evidence, pickled=b"")),
    "writable by others": lambda file: file.chmod(0o620),
    "a link": linked,
    "no file": unreadable,
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_what_is_damaged_or_not_ours_counts_for_nothing(
    damage: Callable[[Path], object], folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    is_read(tree, monkeypatch)
    (file,) = folder.iterdir()
    damage(file)
    monkeypatch.chdir(folder)
    assert is_read(tree, monkeypatch)
    assert not Path("hostile").exists()


def test_what_another_user_wrote_counts_for_nothing(folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    is_read(tree, monkeypatch)
    monkeypatch.setattr(os, "geteuid", lambda: 4711)
    assert is_read(tree, monkeypatch)


@pytest.mark.parametrize("kind", ["absent", "a file", "without bytecode", "not asked for"])
def test_where_nothing_can_be_written_nothing_is_said(
    kind: str, folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    if kind in {"absent", "a file"}:
        folder.rmdir()
    if kind == "a file":
        folder.touch()
    monkeypatch.setattr(sys, "dont_write_bytecode", kind == "without bytecode")
    monkeypatch.setattr(kept_trees, "_begun", kind != "not asked for")
    assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, True]
    assert capfd.readouterr() == ("", "")
    assert not folder.is_dir() or not list(folder.iterdir())


def test_the_trees_used_last_stay(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    trees = [tmp_path / name for name in "abc"]
    files: list[Path] = []
    for number, tree in enumerate(trees):
        tree_of(tree, FILES)
        is_read(tree, monkeypatch)
        (new,) = set(folder.iterdir()) - set(files)
        files.append(new)
        os.utime(new, (number, number))
    (folder / "kept.pyc").write_bytes(b"not one of them")
    is_read(trees[0], monkeypatch)  # used again
    monkeypatch.setattr(kept_trees, "MOST_BYTES", sum(file.stat().st_size for file in files) + 10)
    (trees[0] / "main.py").unlink()
    tree_of(tmp_path / "d", FILES)
    is_read(tmp_path / "d", monkeypatch)
    left = set(folder.iterdir())
    assert files[1] not in left
    assert {files[0], files[2], folder / "kept.pyc"} < left


def test_a_value_is_kept_without_its_hash(tree: Path) -> None:
    evidence = gather(Repository.open(tree))
    hash(evidence)
    assert b"__hash__" not in pickle.dumps(evidence)
    assert pickle.loads(pickle.dumps(evidence)) == evidence  # noqa: S301 - its own


def test_every_example_is_kept_as_it_is_read(folder: Path, examples: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for tree in sorted(path for path in examples.iterdir() if path.is_dir()):
        assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, False], tree.name


def test_what_git_did_not_answer_in_time_is_asked_again(
    folder: Path, tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    commit(tree, "2021-03-01")
    with monkeypatch.context() as patch:
        patch.setattr(git, "SECONDS", 0.0)
        assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, True]
    assert git.unanswered
    git.unanswered.clear()
    assert [is_read(tree, monkeypatch) for _ in range(2)] == [True, False]
