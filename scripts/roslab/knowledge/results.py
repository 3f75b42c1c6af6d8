"""Which files a program writes as its result: figures, tables, maps, recordings."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows


def result_of(path: str) -> str:
    """Return ``figure`` or ``result`` for a file that shows what a program did, ``""`` for any other."""
    found = [row["what"] for row in rows("results") if re.search(row["pattern"], path)]
    return "" if "aside" in found or not found else found[0]
