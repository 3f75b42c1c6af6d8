"""Extensions of other people's repositories whose setup.py stops where no GPU is seen."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def stops_without_gpu() -> dict[str, tuple[str, ...]]:
    """Return the folders of such extensions by the repository: host and path of its address, in small letters."""
    found: dict[str, tuple[str, ...]] = {}
    for row in rows("stops_without_gpu"):
        found[row["repository"]] = (*found.get(row["repository"], ()), row["folder"])
    return found
