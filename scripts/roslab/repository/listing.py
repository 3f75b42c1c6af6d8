"""What lies in a tree: a walk that never leaves it, with a bound on the files."""

from __future__ import annotations

import os
import stat
import time

from roslab.values.dataclass import dataclass

MAX_FILES = 500_000
"""Files listed; a larger tree is read as far as that, with a warning (``Repository.problems``)."""
SKIPPED_FOLDERS = frozenset(
    {".git", ".hg", ".svn", "__pycache__", "node_modules", ".venv", ".tox", ".mypy_cache", ".pytest_cache"}
)
"""Folders that hold no source of the author's."""


@dataclass(frozen=True, kw_only=True, slots=True)
class File:
    """A regular file: its path relative to the root (``/`` between parts) and its size in bytes."""

    path: str
    size: int

    @property
    def name(self) -> str:
        """Last part of the path."""
        return self.path.rpartition("/")[2]

    @property
    def suffix(self) -> str:
        """Suffix of the name, lower-cased, with its dot; ``""`` for none and for ``.bashrc``.

        ``install~``, which an editor keeps of a file before a change, has that sign for one: nobody means it.
        """
        stem, dot, suffix = self.name.rpartition(".")
        return f".{suffix.lower()}" if dot and stem else "~" if self.name.endswith("~") else ""

    @property
    def folder(self) -> str:
        """Path of the folder it lies in, ``""`` for the root."""
        return self.path.rpartition("/")[0]


Stamp = tuple[int, int, int, int]
"""When a file was changed and when anything about it was, in nanoseconds, its size and its number on the disk.

Programs set the first as they like, the second only the system does. https://git-scm.com/docs/racy-git
"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Listing:
    """What a walk of the tree found."""

    files: tuple[File, ...]
    links: frozenset[str]
    """Files among ``files`` that are links to a regular file inside the tree."""
    folder_links: frozenset[str]
    """Links to folders inside the tree, which no walk follows."""
    outside: tuple[str, ...]
    """Links that lead out of the tree or nowhere; never read."""
    empty: tuple[str, ...]
    """Folders with nothing in them: git makes one where a commit records that of another repository."""
    unreadable: tuple[str, ...]
    """Folders that could not be listed: no permission, or a path longer than the system takes."""
    closed: tuple[str, ...]
    """Files that may not be read."""
    truncated: bool
    """There are more than ``MAX_FILES`` files: the rest is not in ``files``."""
    stamps: dict[str, Stamp]
    """Of each file by its path, for a link those of the file that it leads to."""
    begun: int
    """When the walk began, in nanoseconds since 1970."""


def list_tree(root: str) -> Listing:
    """Walk a tree; folders that cannot be listed are named, links to folders are left out."""
    begun = time.time_ns()
    found: dict[str, Stamp] = {}
    links: set[str] = set()
    folder_links: set[str] = set()
    outside: list[str] = []
    empty: list[str] = []
    unreadable: list[str] = []
    closed: list[str] = []
    pending = [""]
    while pending and len(found) < MAX_FILES:
        folder = pending.pop()
        try:
            with os.scandir(f"{root}/{folder}") as entries:
                entry = None
                for entry in entries:
                    if len(found) == MAX_FILES:
                        pending.append(folder)  # not all of it was seen
                        break
                    path = f"{folder}/{entry.name}" if folder else entry.name
                    if entry.is_symlink():
                        _follow(root, path, found, (links, folder_links), outside)
                    elif entry.is_dir(follow_symlinks=False):
                        if entry.name not in SKIPPED_FOLDERS:
                            pending.append(path)
                    elif entry.is_file(follow_symlinks=False):
                        status = entry.stat(follow_symlinks=False)
                        found[path] = _stamp(status)
                        closed += _closed(status, entry.path, path)
                if entry is None:
                    empty.append(folder)
        except OSError:
            unreadable.append(folder)
    return Listing(
        files=tuple([File(path=path, size=found[path][2]) for path in sorted(found)]),
        links=frozenset(links),
        folder_links=frozenset(folder_links),
        outside=tuple(sorted(outside)),
        empty=tuple(sorted(empty)),
        unreadable=tuple(sorted(unreadable)),
        closed=tuple(sorted(closed)),
        truncated=bool(pending),
        stamps=found,
        begun=begun,
    )


def _stamp(status: os.stat_result) -> Stamp:
    return status.st_mtime_ns, status.st_ctime_ns, status.st_size, status.st_ino


def _closed(status: os.stat_result, full: str, path: str) -> tuple[str, ...]:
    """Return a file that may not be read; what is everybody's to read, as most files are, needs no question."""
    return () if status.st_mode & stat.S_IROTH or os.access(full, os.R_OK) else (path,)


def _follow(
    root: str, path: str, found: dict[str, Stamp], links: tuple[set[str], set[str]], outside: list[str]
) -> None:
    """Keep a link to a regular file of the tree; one to a folder is only noted, so no walk can run in circles.

    ``links``: those to files, and those to folders.
    """
    from pathlib import Path  # noqa: PLC0415 - few trees have links

    try:
        target = Path(root, path).resolve(strict=True)
        inside = target.is_relative_to(root) and ".git" not in target.relative_to(root).parts
        status = target.stat()
    except (OSError, RuntimeError):
        outside.append(path)
        return
    if not inside:
        outside.append(path)
    elif stat.S_ISREG(status.st_mode):
        found[path] = _stamp(status)
        links[0].add(path)
    elif stat.S_ISDIR(status.st_mode):
        links[1].add(path)
