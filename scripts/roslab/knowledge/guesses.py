"""What is known of Python packages before one is guessed: tools that no program imports, and names of one module."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache
from typing import Literal

from roslab.knowledge.table import rows


@cache
def tooling(asked_by: Literal["installers", "developers", "compilers", "backends", "ros"]) -> frozenset[str]:
    """Return the tools that install packages, that check code or that compile C++ in conda, or ROS's own packages.

    Or the backends that compile nothing unless a script or a plugin of the project does.

    ROS's are those that its core brings and that ``pip freeze`` lists on a machine with it: pip's index has none.
    """
    return frozenset(row["pip"] for row in rows("python_tooling") if row["asked_by"] == asked_by)


@cache
def ros_modules() -> frozenset[str]:
    """Return the modules that a ROS package of the same name brings, which every distribution released."""
    return frozenset(row["module"] for row in rows("ros_modules"))


def same_module(name: str, other: str) -> bool:
    """Tell whether two packages bring the same module: the builds of OpenCV, the spellings of scikit-learn."""
    return not _rows_of(name).isdisjoint(_rows_of(other))


@cache
def _rows_of(name: str) -> frozenset[int]:
    """Return the numbers of the rows that name a package."""
    return frozenset(number for number, names in enumerate(_names()) if any(_is(name, pattern) for pattern in names))


def _is(name: str, pattern: str) -> bool:
    return fnmatchcase(name, pattern) if "*" in pattern else name == pattern


@cache
def _names() -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(row["names"].split()) for row in rows("same_module"))
