"""Imported targets that only later releases of a library have: its configuration makes them for ``find_package``."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class ImportedTarget:
    """The package of a target, and its first release that has it."""

    package: str
    since: str


@cache
def imported_targets() -> dict[str, ImportedTarget]:
    """Return the table by the name of the target: ``Eigen3::Eigen``, or ``g2o::`` for all of that namespace."""
    return {row["target"]: record(ImportedTarget, row) for row in rows("imported_targets")}


def imported_target(name: str) -> ImportedTarget | None:
    """Return what is known of a target, ``None`` where every release of the library has it or none is known."""
    found = imported_targets()
    return found.get(name) or found.get(f"{name.partition('::')[0]}::")
