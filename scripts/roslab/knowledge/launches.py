"""What a launch prints about nodes that died: it runs on without them, and its exit code does not tell."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows

_COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def dead_nodes(log: str) -> tuple[str, ...]:
    """Return what became of each node that died or did not start, ``talker-2 died with exit code 1``, in their order.

    A node that ended with 0 or was respawned after that did not die; one that dies again and again is named once.
    """
    text = _COLOUR.sub("", log)
    found: dict[str, int] = {}
    for row in rows("launches"):
        for match in re.finditer(row["pattern"], text, flags=re.MULTILINE):
            found.setdefault(row["said"].format(*match.groups()), match.start())
    return tuple(sorted(found, key=lambda said: found[said]))
