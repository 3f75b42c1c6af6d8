"""Libraries that a package of pip is compiled against and does not bring, and packages that bring others with them."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import TypeVar

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement
from roslab.values.version import Version, version_of


@dataclass(frozen=True, kw_only=True, slots=True)
class Series:
    """Releases of a package for which one row holds: from ``first`` on, to the first of the next row."""

    pip: str
    first: str
    newest: str
    """The newest of these releases that the index has."""
    since: str
    """``YYYY-MM-DD``, on which the index got the first of them."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Native(Series):
    """What a package needs to be compiled and to run."""

    part: str
    """Name of the library in a sentence, ``""`` where the package brings it."""
    folder: str
    """Where it has to be, from the home directory."""
    archive: str
    unpacks: str
    """The folder that is in the archive."""
    key: tuple[str, str] | None
    """The file with a key, from the home directory, and its address."""
    variables: tuple[str, ...]
    """Variables that name the folder and the file with the key, or ``NAME=PATH`` for another path."""
    bound: str
    """A limit on a package that compiles it."""
    module: str
    """It compiles itself when it is first imported, and then writes beside itself; ``""`` for what only loads it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Bringing(Series):
    """A package that has pip install another one."""

    part: str
    """What the series is about, where a package has several of them beside each other."""
    extras: tuple[str, ...]
    """Those of its extras that do; none: it always does."""
    brings: str
    """As a line of requirements, ``""`` for nothing."""
    of_index: bool
    """It holds for what the index has, not for what is taken from the package's repository."""


Row = TypeVar("Row", bound=Series)


@cache
def natives() -> tuple[Native, ...]:
    """Return all rows of ``native_parts``."""
    return tuple(
        record(Native, row, key=(row["key"].split()[0], row["key"].split()[1]) if row["key"] else None)
        for row in rows("native_parts")
    )


@cache
def bringing() -> tuple[Bringing, ...]:
    """Return all rows of ``brought_packages``."""
    return tuple(record(Bringing, row, of_index=row["from"] == "index") for row in rows("brought_packages"))


def series_of(asked: Requirement, day: str | None, known: Iterable[Row]) -> Row | None:
    """Return the row for the release that pip takes of a package, on a day or today; ``None`` if there is none."""
    key, pinned = asked.key, asked.release
    ours = [row for row in known if row.pip == key]
    release = version_of(pinned) if pinned else None
    if release:
        return next((row for row in reversed(ours) if Version(row.first) <= release), None)
    fitting = [row for row in ours if asked.specifier.contains(row.newest) or asked.specifier.contains(row.first)]
    then = [row for row in fitting if day is None or row.since <= day]
    return then[-1] if then else next(iter(fitting), None)
