"""Version numbers as people write them.

``packaging`` is imported here alone, so that its patterns wait for their first use, and are kept.
"""

from __future__ import annotations

from functools import cache

from roslab.values.pattern import pattern, postponed

with postponed():
    from packaging.version import InvalidVersion
    from packaging.version import Version as Standard

__all__ = ["InvalidVersion", "Standard", "Version", "minor_of", "version_of"]
_LONG = pattern(r"(\d{18})\d+")
"""A number with more digits than any release has: Python refuses to read one of thousands."""


class Version(Standard):
    r"""A version number in digits of any script, which ``\d`` in a pattern matches, too. Raises ``InvalidVersion``."""

    __slots__ = ()

    def __init__(self, version: str) -> None:
        if not version.isascii():
            from unicodedata import decimal  # noqa: PLC0415 - few are written so

            version = "".join(str(decimal(each, each)) for each in version)
        super().__init__(_LONG.sub(r"\1", version) if len(version) > 18 else version)


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
