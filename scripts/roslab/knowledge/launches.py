"""What a launch prints about nodes that died: it goes on without them, and its exit code does not show it."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows

_COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def dead_nodes(log: str) -> tuple[str, ...]:
    """Return a message for each node that died or did not start, in their order: ``talker-2 died with exit code 1``.

    A node that exited with 0 or was respawned does not count; one that dies repeatedly is named once.
    """
    text = _COLOUR.sub("", log)
    found: dict[str, int] = {}
    for row in rows("launches"):
        for match in re.finditer(row["pattern"], text, flags=re.MULTILINE):
            found.setdefault(row["said"].format(*match.groups()), match.start())
    return tuple(sorted(found, key=lambda said: found[said]))
