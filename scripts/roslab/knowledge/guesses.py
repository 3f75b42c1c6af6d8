"""What is known of Python packages before one is guessed: tools that no program imports, and names of one module."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.pattern import named_by


@cache
def tooling(
    asked_by: Literal["installers", "checkers", "developers", "compilers", "bindings", "backends", "ros", "anaconda"],
) -> frozenset[str]:
    """Return the tools of one sort, by who asks for them.

    Installers; checkers, which also format; developers, whose are tests and documentation; those that compile C++ in
    conda; bindings, which CMake asks for too and an environment may have for its Python alone; backends, which compile
    nothing unless a script or a plugin of the project does; ROS's own, which its core brings and ``pip freeze`` lists
    on a machine with it: pip's index has none; and Anaconda's, which its installer brings: the index has none of their
    releases of then, or none at all.
    """
    return frozenset(row["pip"] for row in rows("python_tooling") if row["asked_by"] == asked_by)


@cache
def tools_of_developers() -> frozenset[str]:
    """Return the tools of those who write a project: no program of it imports one."""
    return tooling("checkers") | tooling("developers")


@cache
def ros_modules() -> frozenset[str]:
    """Return the modules that a ROS package of the same name brings, which every distribution released."""
    return frozenset(row["module"] for row in rows("ros_modules"))


@cache
def successors() -> dict[str, str]:
    """Return for modules that were given up those that took their place."""
    return {row["module"]: row["by"] for row in rows("successors")}


def same_module(name: str, other: str) -> bool:
    """Tell whether two packages bring the same module: the builds of OpenCV, the spellings of scikit-learn."""
    return not _rows_of(name).isdisjoint(_rows_of(other))


@cache
def _rows_of(name: str) -> frozenset[int]:
    """Return the numbers of the rows that name a package."""
    plain, patterns = _names()
    return frozenset(plain.get(name, ())).union(number for number, names in patterns if names.match(name))


@cache
def _names() -> tuple[dict[str, tuple[int, ...]], tuple[tuple[int, re.Pattern[str]], ...]]:
    """Return the rows of each name that is written out, and for the other rows what their names look like."""
    listed = [(number, row["names"].split()) for number, row in enumerate(rows("same_module"))]
    starred = [(number, [name for name in names if "*" in name]) for number, names in listed]
    patterns = tuple((number, named_by(names)) for number, names in starred if names)
    return grouped((name, number) for number, names in listed for name in names), patterns
