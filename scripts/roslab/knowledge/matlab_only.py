"""Functions of MATLAB's products that Octave and its packages do not have."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def matlab_only() -> frozenset[str]:
    """Return their names: ``webcam``."""
    return frozenset(name for row in rows("matlab_only") for name in row["functions"].split())
