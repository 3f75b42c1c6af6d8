"""Reading the CSV tables, each once, on first use."""

from __future__ import annotations

import csv
from functools import cache
from pathlib import Path

_FOLDER = Path(__file__).parent


@cache
def rows(name: str) -> tuple[dict[str, str], ...]:
    """Return the rows of ``NAME.csv``; each has a ``source`` and the ``date`` on which it was read."""
    with (_FOLDER / f"{name}.csv").open(encoding="utf-8", newline="") as stream:
        lines = csv.reader(stream)
        head = next(lines)
        return tuple(dict(zip(head, line, strict=True)) for line in lines)


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
    return (_FOLDER / f"{name}.csv").read_text(encoding="utf-8")
