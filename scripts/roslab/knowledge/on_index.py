"""Packages that pip's index is known to have, by the names under which code that says no more imports them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.table import cells, rows
from roslab.values.name import canonicalize_name

_TABLES = ("prebuilt", "wheels", "often_brought", "all_brought")
"""Those of packages that the index has; the source of such a row says so: ``PyPI: NAME``."""


def named_like(module: str) -> str | None:
    """Return the package of a module's own name that a table knows to be on the index, ``None`` if there is none.

    Not one of which the table of imports knows the modules: they have other names.
    """
    name = canonicalize_name(module)
    return name if name in _known() else None


@cache
def _known() -> frozenset[str]:
    found = {canonicalize_name(row["pip"]) for table in _TABLES for row in rows(table) if _of_index(row)}
    found |= {canonicalize_name(name) for row in rows("all_brought") for name in row["brings"].split()}
    head, *lines = cells("imports")
    other = {canonicalize_name(pip) for pip in {line[head.index("pip")] for line in lines} if pip}
    return frozenset(found - other - not_on_index().keys())


def _of_index(row: dict[str, str]) -> bool:
    return canonicalize_name(row["source"].partition("PyPI: ")[2]).partition(" ")[0] == canonicalize_name(row["pip"])
