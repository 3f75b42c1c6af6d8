"""What runners of tests print about how many they ran: many end with 0 where they found none."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows


def count_of_tests(output: str) -> int | None:
    """Return how many tests ran and were not skipped, ``None`` if no runner says it."""
    counts = {"ran": 0, "skipped": 0}
    said = False
    for row in rows("test_counts"):
        for match in re.finditer(row["pattern"], output, flags=re.MULTILINE):
            said = True
            if row["what"] in counts:
                counts[row["what"]] += int(match[1])
    return max(0, counts["ran"] - counts["skipped"]) if said else None
