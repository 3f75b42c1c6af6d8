"""Tags of packages that pip takes from git, each the last one that was made for a release of a framework."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.version import Version


@dataclass(frozen=True, kw_only=True, slots=True)
class ReleaseTag:
    """The tag for the releases of a framework from one on, up to the next row."""

    framework: str
    since: Version
    tag: str
    """``""`` where the newest commit is made for them."""
    released: str
    """The day of the tag."""


@cache
def release_tags() -> dict[str, tuple[ReleaseTag, ...]]:
    """Return the rows of each package by its normalised name, the oldest framework first."""
    return grouped(
        (
            row["pip"],
            ReleaseTag(
                framework=row["framework"], since=Version(row["since"]), tag=row["tag"], released=row["released"]
            ),
        )
        for row in rows("release_tags")
    )
