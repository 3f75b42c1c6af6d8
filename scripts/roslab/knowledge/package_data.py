"""Data that packages of ROS need and do not bring: a script of theirs fetches it."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class PackageData:
    """The script of a package, and the apt packages that it takes."""

    package: str
    script: str
    """Its path, with ``{distro}`` for the name of the distribution."""
    needs: tuple[str, ...]


@cache
def package_data() -> tuple[PackageData, ...]:
    """Return all rows."""
    return tuple(record(PackageData, row) for row in rows("package_data"))
