"""Reading the CSV tables, each once, on first use."""

from __future__ import annotations

from functools import cache
from os.path import dirname

from roslab.values.kept_file import KeptFile

used: set[str] = set()
"""The paths of the files of which something was asked."""
_FOLDER = dirname(__file__)  # noqa: PTH120 - the tables are many, and `Path` would be slower


@cache
def rows(name: str) -> tuple[dict[str, str], ...]:
    """Return the rows of ``NAME.csv``; each has a ``source`` and the ``date`` on which it was read."""
    found: tuple[dict[str, str], ...] = _kept().value(path_of(name), _rows)
    return found


def cells(name: str) -> list[list[str]]:
    """Return the rows of a large ``NAME.csv``, its head first, of which few are wanted by the names of their cells."""
    found: list[list[str]] = _kept().value(path_of(name), _cells)
    return found


def path_of(name: str) -> str:
    """Return the path of ``NAME.csv``."""
    return _path(f"{name}.csv")


def _path(file: str) -> str:
    path = f"{_FOLDER}/{file}"
    used.add(path)
    return path


@cache
def _kept() -> KeptFile:
    """Return what was kept of the tables: a plan reads some ninety, whose rows are quicker read from one file."""
    return KeptFile(__spec__, "rows")


def _rows(path: str) -> tuple[dict[str, str], ...]:
    head, *lines = _cells(path)
    return tuple([dict(zip(head, line, strict=True)) for line in lines])


def _cells(path: str) -> list[list[str]]:
    import csv  # noqa: PLC0415 - the rows of nearly all tables are kept

    with open(path, encoding="utf-8", newline="") as stream:  # noqa: PTH123 - as above
        return list(csv.reader(stream))


def row(name: str, key: str) -> dict[str, str] | None:
    """Return the row of a large ``NAME.csv`` whose first column is ``key``, ``None`` if there is none.

    The other rows are not parsed; in such a table each stands on a line of its own.
    """
    text = whole(name)
    start = text.find(f"\n{key},") + 1
    if not start:
        return None
    lines = (text[: text.index("\n")], text[start : text.index("\n", start)])
    head, found = (_quoted(line) if '"' in line else line.split(",") for line in lines)
    return dict(zip(head, found, strict=True))


def _quoted(line: str) -> list[str]:
    import csv  # noqa: PLC0415 - as above

    return next(csv.reader([line]))


@cache
def whole(name: str) -> str:
    """Return the text of ``NAME.csv``, for a search in a large one."""
    return text_of(f"{name}.csv")


def text_of(file: str) -> str:
    """Return the text of another file beside the tables."""
    with open(_path(file), encoding="utf-8") as stream:  # noqa: PTH123 - as above
        return stream.read()
