"""The folders of headers by which libraries that people copy into their trees are known."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def copied_libraries() -> frozenset[str]:
    """Return the names of the folders: ``Eigen``, ``igl``, ``boost``."""
    return frozenset(row["folder"] for row in rows("copied_libraries"))
