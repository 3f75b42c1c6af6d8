"""Frameworks that only an index of their maker's has, with the release of each that goes with another product's."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.version import Version


@dataclass(frozen=True, kw_only=True, slots=True)
class Release:
    """One release, and what pip is asked for to get it."""

    release: str
    beside: tuple[str, str]
    """The product that it is for, and the release of that: ``isaacsim``, ``4.5``."""
    since: str
    """``YYYY-MM-DD``: work of before was done with an older one."""
    asks: tuple[str, ...]
    """Lines of pip; what comes from git is installed editable."""


@dataclass(frozen=True, kw_only=True, slots=True)
class OtherIndex:
    """A framework, the modules by which code tells that it needs it, and the index."""

    pip: str
    modules: tuple[str, ...]
    also: tuple[str, ...]
    """Further modules that it brings, and that no other package is taken for."""
    said: str
    """How pages write its name, as a pattern."""
    index: str
    consent: str
    """The variable by which the user accepts its licence; it waits for an answer without."""
    source: str
    releases: tuple[Release, ...]
    """The oldest first."""


@cache
def other_indexes() -> tuple[OtherIndex, ...]:
    """Return the frameworks in the order in which one is taken: who needs the first needs no other one."""
    found = (record(OtherIndex, row, releases=tuple(_releases(row["pip"]))) for row in rows("other_indexes"))
    return tuple(found)


def _releases(pip: str) -> Iterator[Release]:
    ours = [row for row in rows("other_index_releases") if row["pip"] == pip]
    for row in sorted(ours, key=lambda row: Version(row["release"])):
        product, _, number = row["beside"].partition(" ")
        yield record(Release, row, beside=(product, number))
