"""Definitions with which the headers of a library are all of it, so that code need not link what is compiled."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class HeaderDefinition:
    """A definition of the preprocessor, and what needs it where CMake finds no library."""

    include: str
    """The beginning of the headers that code includes."""
    definition: str
    """``NAME=``: empty, so that code which defines it itself defines the same."""
    found_as: tuple[str, ...]
    """Names by which CMake finds or links a library that has no need of it, in lower case."""


@cache
def header_definitions() -> tuple[HeaderDefinition, ...]:
    """Return all rows."""
    return tuple(record(HeaderDefinition, row) for row in rows("header_definitions"))
