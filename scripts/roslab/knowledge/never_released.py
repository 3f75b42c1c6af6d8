"""Numbers that frameworks left out: a page that names one of them means another package, or has a slip."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.version import Version, version_of


def never_released(package: str, release: str) -> bool:
    """Tell whether a release (``0.7.0``, ``0.7``) is between two that follow each other: there never was such a one.

    ``package``: its name in the table of frameworks.
    """
    gaps = _gaps().get(package, ())
    version = version_of(release) if gaps else None
    numbers = Version(version.base_version) if version else None
    return numbers is not None and any(first <= numbers < before for first, before in gaps)


@cache
def _gaps() -> dict[str, tuple[tuple[Version, Version], ...]]:
    """Return the numbers that each package left out: from the first, and up to the next release."""
    return grouped((row["package"], (Version(row["first"]), Version(row["before"]))) for row in rows("never_released"))
