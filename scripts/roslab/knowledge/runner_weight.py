"""What GitHub's own runners carry that no image is built with, the heaviest first."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def runner_weight() -> tuple[tuple[str, str], ...]:
    """Return folders and what they hold."""
    return tuple((row["path"], row["holds"]) for row in rows("runner_weight"))
