"""Reading the CSV tables, each once, on first use."""

from __future__ import annotations

import csv
from functools import cache
from os.path import dirname

_FOLDER = dirname(__file__)  # noqa: PTH120 - the tables are many, and `Path` would be slower


@cache
def rows(name: str) -> tuple[dict[str, str], ...]:
    """Return the rows of ``NAME.csv``; each has a ``source`` and the ``date`` on which it was read."""
    head, *lines = cells(name)
    return tuple([dict(zip(head, line, strict=True)) for line in lines])


def cells(name: str) -> list[list[str]]:
    """Return the rows of a large ``NAME.csv``, its head first, of which few are wanted by the names of their cells."""
    with open(f"{_FOLDER}/{name}.csv", encoding="utf-8", newline="") as stream:  # noqa: PTH123 - as above
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
    head, found = (next(csv.reader([line])) if '"' in line else line.split(",") for line in lines)
    return dict(zip(head, found, strict=True))


@cache
def whole(name: str) -> str:
    """Return the text of ``NAME.csv``, for a search in a large one."""
    return text_of(f"{name}.csv")


def text_of(file: str) -> str:
    """Return the text of another file beside the tables."""
    with open(f"{_FOLDER}/{file}", encoding="utf-8") as stream:  # noqa: PTH123 - as above
        return stream.read()
