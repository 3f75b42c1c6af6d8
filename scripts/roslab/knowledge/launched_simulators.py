"""Simulators that a launch file starts by a module of Python and that no package of ROS brings."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class LaunchedSimulator:
    """A simulator, and how the module finds it."""

    program: str
    package: str
    """Of apt, where a source of it is added."""
    variables: tuple[str, ...]
    """Each may name the folder that it is in."""
    address: str
    """Where it is to be had."""
    file: str
    """The package of Debian of the release that the module of these ``distros`` looks for, for amd64 alone."""
    folder: str
    """Where that puts it."""
    distros: tuple[str, ...]


@cache
def launched_simulators() -> dict[str, LaunchedSimulator]:
    """Return the simulators by the modules that start them."""
    return {row["module"]: record(LaunchedSimulator, row) for row in rows("launched_simulators")}
