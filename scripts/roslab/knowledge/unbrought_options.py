"""Options of libraries' CMake that switch on what needs something which no image has by itself."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Needs:
    """What such an option needs."""

    library: str
    """The library that has it, ``""`` for whichever."""
    what: str
    apt: tuple[str, ...]
    """The packages that bring it, none where nothing does."""


@cache
def needs_of_options() -> dict[str, tuple[Needs, ...]]:
    """Return by the name of an option, ``WITH_HSL``, what it needs."""
    found: dict[str, tuple[Needs, ...]] = {}
    for row in rows("unbrought_options"):
        needed = Needs(library=row["library"], what=row["needs"], apt=tuple(row["apt"].split()))
        for switch in row["switches"].split():
            found[switch] = (*found.get(switch, ()), needed)
    return found
