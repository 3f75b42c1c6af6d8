"""Packages of plain Python that pip installs for any Python, and that do not run on newer ones."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version, version_of


def runs_up_to(package: str, release: str) -> str | None:
    """Return the newest Python on which a release of a package runs, ``None`` where the table tells none."""
    row = _rows().get(package)
    if row is None or version_of(release) is None:
        return None
    return row["python"] if Version(release) < Version(row["below"]) else None


@cache
def _rows() -> dict[str, dict[str, str]]:
    return {row["pip"]: row for row in rows("runs_up_to")}
