"""Base images that can no longer be used: not built any more, or without packages to install."""

from __future__ import annotations

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern


def ended(image: str) -> str | None:
    """Return why an image can no longer be a base, ``None`` if no row matches it."""
    row = next((row for row in rows("ended_bases") if pattern(row["pattern"]).fullmatch(image)), None)
    return row["why"].format(image=image) if row else None
