"""Files at a repository's root by which a build tool builds it that no step of the image calls."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class OtherBuilder:
    """A file and its tool."""

    file: str
    contains: str
    """What its text matches, ``""`` for any."""
    builder: str
    makes_cmake_in: tuple[str, ...]
    """The folders beside it whose CMake includes files that only the tool makes."""


@cache
def other_builders() -> tuple[OtherBuilder, ...]:
    """Return the tools, each with its file."""
    return tuple(record(OtherBuilder, row) for row in rows("other_builders"))


@cache
def of_cpp() -> frozenset[str]:
    """Return the tools that are used for C++ before all."""
    return frozenset(row["builder"] for row in rows("other_builders") if row["compiles_cpp"] == "yes")
