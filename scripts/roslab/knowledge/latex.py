"""The packages of apt by which matplotlib has text set by LaTeX."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def latex() -> tuple[str, ...]:
    """Return their names."""
    return tuple(row["apt"] for row in rows("latex"))
