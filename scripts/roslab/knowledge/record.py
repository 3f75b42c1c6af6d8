"""Rows of the tables as values, whose fields are called like the columns."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from typing import Any, TypeVar

from roslab.values.dataclass import fields

Record = TypeVar("Record")
Value = TypeVar("Value")

_READ: dict[str, Callable[[str], object]] = {
    "str": str,
    "str | None": lambda cell: cell or None,
    "tuple[str, ...]": lambda cell: tuple(cell.split()),
}
"""How a cell is read, by the type of its field: one of several words has blanks between them."""


def record(kind: Callable[..., Record], row: Mapping[str, str], **others: object) -> Record:
    """Return a row as a value of a dataclass; ``others`` are the fields that are more than what their cells hold.

    Raises ``KeyError`` for a field that has no column, or a type of another kind than these.
    """
    read = {name: make(row[name]) for name, make in _cells(kind) if name not in others}
    return kind(**read, **others)


@cache
def _cells(kind: Any) -> tuple[tuple[str, Callable[[str], object]], ...]:
    """Return the fields, each with what reads its cell; of other types it is looked for where they are not given."""
    return tuple((each.name, _READ.get(str(each.type), _unread)) for each in fields(kind))


def _unread(cell: str) -> object:
    raise KeyError(cell)


def grouped(pairs: Iterable[tuple[str, Value]]) -> dict[str, tuple[Value, ...]]:
    """Return the values of each key, in their order."""
    found: dict[str, list[Value]] = {}
    for key, value in pairs:
        found.setdefault(key, []).append(value)
    return {key: tuple(values) for key, values in found.items()}
