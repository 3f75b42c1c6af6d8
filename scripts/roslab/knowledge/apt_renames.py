"""System packages that have another name in some releases."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def _table() -> dict[tuple[str, str], str]:
    return {(row["apt"], release): row["renamed"] for row in rows("apt_renames") for release in row["releases"].split()}


def name_in(name: str, release: str) -> str:
    """Return a package's name in a release of Ubuntu or Debian, by its codename; mostly it is the same everywhere."""
    return _table().get((name, release), name)
