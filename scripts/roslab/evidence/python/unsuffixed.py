"""Programs of Python whose names have no ending, as nodes and commands have them: their first line names Python."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
"""Bytes of such a program: a longer file is data, or carries some."""
MAX_FILES = 500
"""Most files whose first line is read, those nearest to the root first."""
_LONGEST = 120
"""Bytes that are read for a first line."""
_FIRST_LINE = pattern(r"#![ \t]*/\S*?(?:/env[ \t]+(?:-S[ \t]+)?(?:/\S*/)?|/)python[\d.]*[ \t\r\n]")


def unsuffixed(repository: Repository) -> Iterator[File]:
    """Yield the programs of Python without an ending, nearest to the root first; no hidden one, as a hook of git."""
    files = [file for file in repository.suffixed("") if 0 < file.size <= MAX_SIZE and not _hidden(file)]
    for file in nearest(files)[:MAX_FILES]:
        if _FIRST_LINE.match(repository.read_bytes(file, limit=_LONGEST).decode("latin-1")):
            yield file


def _hidden(file: File) -> bool:
    return any(part.startswith(".") for part in file.path.split("/"))
