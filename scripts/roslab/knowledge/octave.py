"""GNU Octave in Ubuntu: its programs, and the packages that have what ``pkg load`` loads."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows

OCTAVE = ("octave", "octave-cli")
"""The program, and itself without windows: Ubuntu's package ``octave`` has both."""


@cache
def octave_packages() -> dict[str, str]:
    """Return the package of apt that has each package of Octave, by its name in lower case."""
    return {row["package"]: row["apt"] for row in rows("octave_packages")}
