"""What a shell runs for the calls of tasks, whatever program runs these."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from roslab.values.pattern import pattern

MOST_CALLS = 500
"""Most different calls of the tasks of one file of which the lines are looked up."""
_ENTERS = pattern(r"(?:^|[;&|][ \t]*)(?:cd|pushd)\b")


class TaskCalls:
    """The tasks of one file, with what each call of them runs, which is found once for all pages."""

    def __init__(self, run: Callable[[str], str | None]) -> None:
        self._run = run
        self._known: dict[str, str | None] = {}

    def line_of(self, call: str) -> str | None:
        """Return what a shell runs for a call, on one line; ``None`` where that is not known."""
        if call not in self._known:
            if len(self._known) >= MOST_CALLS:
                return None
            self._known[call] = self._run(call)
        return self._known[call]


def joined(lines: Sequence[str]) -> str | None:
    """Return the lines of a task on one, each that goes to a folder in a shell of its own; ``None`` for none."""
    if not lines or any("`" in line for line in lines):
        return None
    whole = ""
    for line in lines:  # each is run in a shell of its own
        alone = f"({line})" if len(lines) > 1 and _ENTERS.search(line) else line
        whole += ("" if not whole else " " if re.search(r"(?<!&)&$", whole) else " && ") + alone
    return whole
