"""Version numbers as people write them."""

from __future__ import annotations

from functools import cache

from packaging.version import InvalidVersion, Version


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
