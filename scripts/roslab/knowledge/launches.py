"""What a launch prints about its nodes: it goes on without one that died, and its exit code does not show it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern

_COLOUR = pattern(r"\x1b\[[0-9;]*m")


def dead_nodes(log: str) -> tuple[str, ...]:
    """Return a message for each node that died or did not start, in their order: ``talker-2 died with exit code 1``.

    A node that exited with 0 or was respawned does not count, nor one that the launch had told to end: few Python nodes
    take that signal for a normal end. One that dies repeatedly is named once.
    """
    text = _COLOUR.sub("", log)
    ended: dict[str, int] = {}
    for _, match in _matches(text, "ended"):
        ended.setdefault(match[1], match.start())
    found: dict[str, int] = {}
    for said, match in _matches(text, "died"):
        if match.start() < ended.get(match[1], len(text)):
            found.setdefault(said.format(*match.groups()), match.start())
    return tuple(sorted(found, key=lambda said: found[said]))


def waiting_nodes(log: str) -> int:
    """Return how many nodes a launch has listed and not yet tried to start; those of ROS 2 list none."""
    text = _COLOUR.sub("", log)
    listed, tried = (sum(1 for _ in _matches(text, event)) for event in ("listed", "tried"))
    return max(0, listed - tried)


def _matches(text: str, event: str) -> Iterator[tuple[str, re.Match[str]]]:
    """Yield what is said of each line about this event, and the line; its first group is the node."""
    for row in rows("launches"):
        if row["event"] == event:
            yield from ((row["said"], match) for match in re.finditer(row["pattern"], text, flags=re.MULTILINE))


def launches(command: str) -> bool:
    """Tell whether a process with this command line is a launch."""
    return any(re.search(row["pattern"], command) for row in rows("launches") if row["event"] == "launcher")
