"""What is known of Python packages before one is guessed: tools that no program imports, and names of one module."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache
from typing import Literal

from roslab.knowledge.table import rows


@cache
def tooling(asked_by: Literal["installers", "developers"]) -> frozenset[str]:
    """Return the tools that install packages, or those with which developers check their code."""
    return frozenset(row["pip"] for row in rows("python_tooling") if row["asked_by"] == asked_by)


@cache
def same_module(name: str, other: str) -> bool:
    """Tell whether two packages bring the same module: the builds of OpenCV, the spellings of scikit-learn."""
    return any(_one_of(name, names) and _one_of(other, names) for names in _names())


@cache
def _names() -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(row["names"].split()) for row in rows("same_module"))


def _one_of(name: str, patterns: tuple[str, ...]) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in patterns)
