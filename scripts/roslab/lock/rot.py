"""What became of an image: built again from its source today, and beside it the one that was archived."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Literal

from roslab.lock.comparison import Change, Comparison
from roslab.values.dataclass import dataclass

State = Literal["built", "proved", "drifted", "archived only", "broken", "unknown"]
MEANINGS: Mapping[State, str] = {
    "built": "It builds from its source today; nothing was run to prove it.",
    "proved": "It builds and runs from its source today, with the very packages of the archived image.",
    "drifted": "It builds and runs from its source today, with other packages than the archived image has.",
    "archived only": "It can no longer be made from its source. The archived image still runs.",
    "broken": "It can no longer be made from its source, and no archived image runs.",
    "unknown": "The network, a server or the machine failed: this says nothing of the source.",
}
SHORTEST = 3
"""Fewest characters of a package's name that are looked for in an output: shorter ones are words."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Side:
    """How one of the two images fared."""

    proved: bool
    """It was there, or could be built, and passed every proof."""
    by_machine: bool = False
    """It failed, and the network, a server or the machine was to blame."""
    failure: str = ""
    """What failed, in words."""
    output: str = ""
    """What the failed proof or step printed."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Finding:
    """What a run of the watch found."""

    state: State
    today: Side
    archived: Side | None
    """``None`` where nothing was ever published."""
    moved: Comparison | None
    """``None`` where one of the two could not be read."""
    suspects: tuple[Change, ...]
    """Of what moved, that which the failed output names."""


def judged(today: Side, archived: Side | None, moved: Comparison | None, *, proofs: bool) -> Finding:
    """Return what the two sides tell; ``proofs`` says whether the plan has any."""
    changed = bool(moved and moved.moved)
    state: State
    if today.by_machine or (archived and archived.by_machine and not today.proved):
        state = "unknown"
    elif today.proved:
        state = "drifted" if changed else "proved" if proofs else "built"
    else:
        state = "archived only" if archived and archived.proved else "broken"
    suspects = named(moved, today.output) if moved and not today.proved else ()
    return Finding(state=state, today=today, archived=archived, moved=moved, suspects=suspects)


def named(moved: Comparison, output: str) -> tuple[Change, ...]:
    """Return what moved and is named in an output: a module of it, a path of it, or its own name."""
    words = set(re.findall(r"[a-z0-9]+(?:[._+-][a-z0-9]+)*", output.lower().replace("_", "-")))
    words |= {part for word in words for part in word.split(".")}
    return tuple(
        change
        for change in moved.moved
        if len(name := change.name.partition(" ")[0].partition(":")[0].lower().replace("_", "-")) >= SHORTEST
        and (name in words or name.removeprefix("python3-") in words)
    )


def counted(finding: Finding) -> str:
    """Return how much moved, and which of it changed the proof."""
    if finding.moved is None:
        return "What moved is not known: one of the two images cannot be read."
    text = f"{len(finding.moved.moved)} of {finding.moved.packages} packages moved"
    names = ", ".join(f"`{change.name}`" for change in finding.suspects)
    return f"{text}, of these {len(finding.suspects)} changed the proof{f': {names}' if names else ''}."
