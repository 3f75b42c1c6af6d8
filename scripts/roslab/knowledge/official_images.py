"""Images of Docker Hub that belong to no user: their names have no slash."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def _names() -> frozenset[str]:
    return frozenset(row["image"] for row in rows("official_images"))


def published(reference: str) -> bool:
    """Tell whether a registry may have an image; of names without a slash, Docker Hub has the official ones only."""
    name = reference.partition("@")[0]
    return "/" in name or name.partition(":")[0].lower() in _names()
