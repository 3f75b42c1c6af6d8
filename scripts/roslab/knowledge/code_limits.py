"""What code compiles with: signs of the versions of a library, and the versions that each Ubuntu has."""

from __future__ import annotations

import re
from functools import cache
from itertools import takewhile
from typing import Literal, cast

from roslab.knowledge.hints import Hints, hints
from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.version import Version

Sign = Literal[
    "include", "name", "standard", "option", "cpp11", "line", "annotation", "python", "launch", "module", "cmake"
]
"""A header, a name in C++, a C++ standard that CMake asks for, the name of one in an option that a compiler refuses, a
header in what is compiled as C++11, what stands on one line of Python code, or of such code whose annotations are
computed, or on several, what a launch file in Python has, what pkg-config is asked for, a command of CMake."""
OF_ROS2 = "ROS 2: "
"""Before the name of a repository of ROS 2, in the place of a library: its versions are distributions."""
_OWN = frozenset({"library", "same_major", "source", "date"})


@dataclass(frozen=True, kw_only=True, slots=True)
class Limit:
    """A sign in the code, and the versions of a library that it compiles with.

    Where ``below`` is older than ``at_least``, what the sign names was away between the two.
    """

    where: Sign
    pattern: re.Pattern[str]
    library: str
    at_least: str | None
    below: str | None
    what: str
    hints: Hints
    """For ``line`` and ``annotation``, one of them stands on that line."""


@cache
def limits() -> tuple[Limit, ...]:
    """Return every sign."""
    return tuple(
        record(
            Limit,
            row,
            where=cast("Sign", row["where"]),
            pattern=pattern(row["pattern"], re.MULTILINE),
            hints=hints(row["hints"]),
        )
        for row in rows("code_limits")
    )


@cache
def _versions() -> dict[str, dict[str, str]]:
    return {row["library"]: {key: row[key] for key in row if key not in _OWN} for row in rows("library_versions")}


@cache
def _same_major() -> frozenset[str]:
    return frozenset(row["library"] for row in rows("library_versions") if row["same_major"] == "yes")


def version_of(library: str, ubuntu: str, *, ros: bool = False) -> str | None:
    """Return the version of a library in an Ubuntu, ``None`` where the table has none; ROS may bring another one."""
    own = _versions().get(f"{library} of ROS", {}).get(ubuntu) if ros else None
    return own or _versions().get(library, {}).get(ubuntu) or None


def _newest(library: str, ubuntu: str) -> str:
    """Return the newest version of a library in an older Ubuntu; one that the table does not have is the newest."""
    known = _versions().get(library, {})
    older = tuple(takewhile(lambda each: each != ubuntu, known))
    return next((known[each] for each in reversed(older) if known[each]), "")


def fits(library: str, ubuntu: str, *, at_least: str | None, below: str | None, ros: bool = False) -> bool:
    """Tell whether an Ubuntu's version lies in the bounds; unknown ones do, but no Ubuntu goes back to an older one."""
    found = version_of(library, ubuntu, ros=ros)
    if found is None:
        newest = _newest(library, ubuntu)
        return below is None or not newest or Version(newest) < Version(below)
    version = Version(found)
    return (at_least is None or version >= Version(at_least)) and (below is None or version < Version(below))


def bounds_of(library: str, asked: str) -> tuple[str, str | None]:
    """Return the oldest release that ``find_package(LIBRARY ASKED)`` takes, and the first newer one that it refuses."""
    return asked, str(Version(asked).major + 1) if library in _same_major() else None


def satisfies(library: str, ubuntu: str, asked: str, *, ros: bool = False) -> bool:
    """Tell whether ``find_package(LIBRARY ASKED REQUIRED)`` succeeds on an Ubuntu; of an unknown library it does.

    No Ubuntu goes back to an older one, so that none which the table does not have yet has the major release asked for
    if a newer one was there before.
    """
    found = version_of(library, ubuntu, ros=ros)
    major = Version(asked).major
    if found is None:
        newest = _newest(library, ubuntu) if library in _same_major() else ""
        return not newest or Version(newest).major <= major
    same = library not in _same_major() or Version(found).major == major
    return same and Version(found) >= Version(asked)
