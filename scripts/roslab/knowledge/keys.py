"""The keys that sign package sources: each a file of this folder, so that an image needs no key server."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows, text_of


@cache
def key(name: str) -> str:
    """Return the armoured key of a row of ``keys.csv``. Raises ``KeyError`` for another name."""
    if not any(row["name"] == name for row in rows("keys")):
        raise KeyError(name)
    return text_of(f"keys/{name}.asc")


def expires(name: str) -> str:
    """Return the day on which a key expires, ``YYYY-MM-DD``, ``""`` if it never does or is not known."""
    return next((row["expires"] for row in rows("keys") if row["name"] == name), "")
