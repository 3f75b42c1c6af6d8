"""Version numbers as people write them.

``packaging`` is imported here alone, so that its patterns wait for their first use, and are kept.
"""

from __future__ import annotations

from functools import cache

from roslab.values.pattern import postponed

with postponed():
    from packaging.version import InvalidVersion, Version

__all__ = ["InvalidVersion", "Version", "minor_of", "version_of"]


@cache
def version_of(text: str) -> Version | None:
    """Parse a version number, ``None`` if it is none by the standard (``3.x``, ``latest``)."""
    try:
        return Version(text)
    except InvalidVersion:
        return None


def minor_of(text: str) -> str | None:
    """Return ``3.8`` for ``3.8.10``, ``None`` if there are no two numbers."""
    version = version_of(text)
    return f"{version.major}.{version.minor}" if version and len(version.release) > 1 else None
