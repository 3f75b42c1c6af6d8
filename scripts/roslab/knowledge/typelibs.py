"""The packages with which Python sees libraries of GObject: ``gi.require_version("Gtk", "3.0")``."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def typelibs() -> dict[tuple[str, str], str]:
    """Return the apt package of each name and version."""
    return {(row["name"], row["version"]): row["apt"] for row in rows("typelibs")}
