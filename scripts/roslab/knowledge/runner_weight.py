"""Large folders on GitHub's runners that no image build uses, the largest first."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def runner_weight() -> tuple[tuple[str, str], ...]:
    """Return each folder with a description of its contents."""
    return tuple((row["path"], row["holds"]) for row in rows("runner_weight"))
