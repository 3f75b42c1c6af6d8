"""Packages in archives that nobody can fetch without an account, and that pip installs where they were unpacked."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def unpacked_archives() -> dict[str, str]:
    """Return by normalised name the folder that pip installs, as the archive has it."""
    return {row["pip"]: row["folder"] for row in rows("unpacked_archives")}
