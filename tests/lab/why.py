"""Say in a few lines why a run of a workflow failed, from a log of hundreds."""

from __future__ import annotations

import re

BEFORE = 25
"""Lines before a step's failure: what the step said last."""
MOST = 150
"""Lines in all, the first ones: what failed first may have made the rest fail."""
LONGEST = 1000
"""Characters of a line: a value that is shown as Python writes it holds a whole log in one."""
_FAILED = re.compile(r"\u274c|::error\b|\bfatal error: ")
"""act's mark of a step that failed, an error annotation, and the end of act itself."""


def of_run(text: str) -> str:
    """Return the lines of a run's log that tell why it failed, with those before each; "" where none does.

    Lines that are left out between two of them are told by their number.
    """
    lines = [line for line in text.splitlines() if len(line) <= LONGEST]
    wanted: set[int] = set()
    for number, line in enumerate(lines):
        if _FAILED.search(line):
            wanted |= set(range(max(0, number - BEFORE), number + 1))
    told: list[str] = []
    last = -1
    for number in sorted(wanted):
        if number > last + 1:
            told.append(f"[{number - last - 1} lines]")
        told.append(lines[number])
        last = number
    return "\n".join(told[:MOST])
