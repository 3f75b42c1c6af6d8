"""Known failures of builds, as tables: what their logs say, the cause in plain words, what to do, and samples.

A failure is one table ``[id]`` in a file ``failures_WORLD.toml``:

=============  =========================================================================================
``pattern``    regular expression on the failed step's lines, joined; named groups are the captured names,
               ``name2`` being another place of ``name``; every repetition has an upper bound
``also``       must match too, anywhere in the step's lines or its instruction; ``unless`` must not, in its lines
``before``     must match in the instruction or the lines of an earlier step, or in this one's instruction
``not_before`` must not match any earlier instruction, nor this one; the log must hold the build's first step
``copied``     ``true``: an earlier COPY or ADD must have brought the captured ``{path}`` into the image
``command``    must match the step's instruction (empty where the log tells of no step)
``extra``      more names, searched for in all lines of the step (``where = "command"``: in the instruction;
               ``extra_before = true``: the nearest one before the matched line)
``every``      collect the names of all matches, not of the first alone
``errors``     match only where the step says CMake Error, ERROR or the like
``lookup``     a table that turns a captured name into others, see ``explain/names.py``; ``required = true``
               lets the failure match only where that table knows the name
``cause``      in plain words, with ``{name}`` of what was captured
``fix``        what to do; ``otherwise`` where the lookup found nothing
``repair``     the key of roslab.yaml that a found ``{package}`` is added to; ``key:value`` for a fixed value
``certainty``  ``certain`` (default), or ``likely``: reported as such, and never applied without being asked
``rank``       1 to 9 (default 5): a lower one wins over a higher one, then the earlier line
``passing``    ``true``: builds often go on after it; it counts only if no other failure is known after its line
``machine``    ``true``: the network's, a server's or the machine's fault; the same source may build an hour later
``source``     addresses where the fact stands, ``date`` when it was read
``sample``     a log of our own making that it explains, ``unlike`` one that looks alike and that it must not
=============  =========================================================================================
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

from roslab.values import toml
from roslab.values.dataclass import dataclass

WORLDS = ("images", "apt", "system", "fetch", "ros", "python", "native", "languages", "starting", "own_words")
"""The files, in their order: of two failures of one rank that match on one line, the earlier one wins."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Failure:
    """One known failure; the fields are the table's."""

    id: str
    pattern: str
    cause: str
    fix: str
    source: str
    date: str
    sample: str
    unlike: str
    also: str = ""
    unless: str = ""
    before: str = ""
    not_before: str = ""
    copied: bool = False
    command: str = ""
    extra: str = ""
    where: str = ""
    extra_before: bool = False
    every: bool = False
    errors: bool = False
    passing: bool = False
    machine: bool = False
    lookup: str = ""
    required: bool = False
    otherwise: str = ""
    repair: str = ""
    certainty: str = "certain"
    rank: int = 5


@cache
def failures() -> tuple[Failure, ...]:
    """Return every known failure, those of a lower rank first."""
    found = [Failure(id=name, **row) for world in WORLDS for name, row in _world(world).items()]
    return tuple(sorted(found, key=lambda failure: failure.rank))


@cache
def of_machine() -> frozenset[str]:
    """Return the failures that say nothing of the source: the network, a server or the machine failed."""
    return frozenset(failure.id for failure in failures() if failure.machine)


@cache
def compiled(pattern: str) -> re.Pattern[str]:
    """Return a pattern of the tables, compiled once; ``^`` and ``$`` mean the ends of a line."""
    return re.compile(pattern, re.MULTILINE)


def _world(name: str) -> dict[str, Any]:
    return toml.parsed(Path(__file__).with_name(f"failures_{name}.toml").read_text(encoding="utf-8"))
