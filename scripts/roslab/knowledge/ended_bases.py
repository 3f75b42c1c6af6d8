"""Base images that can no longer be used: not built any more, or without packages to install."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows


def ended(image: str) -> str | None:
    """Return why an image can no longer be a base, ``None`` if no row matches it."""
    row = next((row for row in rows("ended_bases") if re.fullmatch(row["pattern"], image)), None)
    return row["why"].format(image=image) if row else None
