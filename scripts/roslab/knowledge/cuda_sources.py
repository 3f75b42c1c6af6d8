"""Packages of Python that pip compiles for CUDA, as they have no wheels, and the newest CUDA that old releases know."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.version import Version


@cache
def _table() -> tuple[tuple[str, Version, Version], ...]:
    found = ((row["package"], Version(row["below"]), Version(row["newest"])) for row in rows("cuda_sources"))
    return tuple(sorted(found))


def newest_cuda(package: str, release: str) -> Version | None:
    """Return the newest CUDA that a release compiles with, ``None`` where no row tells it."""
    return next((newest for name, below, newest in _table() if name == package and Version(release) < below), None)
