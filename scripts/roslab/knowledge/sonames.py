"""The apt packages of shared libraries whose names Debian's rule does not give."""

from __future__ import annotations

from roslab.knowledge.table import rows


def sonames() -> str:
    """Return a line for each: the library's name, as programs are linked with it, and its package."""
    return "\n".join(f"{row['library']} {row['apt']}" for row in rows("sonames"))
