"""The last releases of packages for a Python: who lists several of them had that one, and later ones need a newer."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.version import Version, version_of


@cache
def last_for_python() -> dict[tuple[str, str], str]:
    """Return the Python for which a release was the last of its package, by normalised name and release."""
    return {(row["pip"], row["release"]): row["python"] for row in rows("last_for_python")}


def outgrown(package: str, release: str) -> str | None:
    """Return the newest Python that is too old for a release, ``None`` where the table has none for the package.

    It needs a newer one than those whose last release came before it. Of what is no version nothing is known.
    """
    if version_of(release) is None:
        return None
    older = [python for last, python in _releases().get(package, ()) if Version(last) < Version(release)]
    return max(older, key=Version, default=None)


@cache
def _releases() -> dict[str, tuple[tuple[str, str], ...]]:
    """Return the last releases of each package, each with its Python."""
    return grouped((row["pip"], (row["release"], row["python"])) for row in rows("last_for_python"))
