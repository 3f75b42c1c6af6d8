"""Base images that still have a name and nothing behind it: no longer built, or without packages to install."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows


def ended(image: str) -> str | None:
    """Return why nothing can be built on an image any more, ``None`` for one that no row matches."""
    row = next((row for row in rows("ended_bases") if re.fullmatch(row["pattern"], image)), None)
    return row["why"].format(image=image) if row else None
