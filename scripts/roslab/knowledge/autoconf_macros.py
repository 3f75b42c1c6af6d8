"""Macros of Autoconf, and the apt packages that define them or have the programs that they look for."""

from __future__ import annotations

from roslab.knowledge.table import rows

_ANY = "*"


def packages_of_macro(name: str) -> tuple[str, ...]:
    """Return the packages, none for a macro that needs no more than Autoconf, Automake and libtool."""
    found = (row["apt"].split() for row in rows("autoconf_macros") if _is(name, row["macro"]))
    return tuple(package for packages in found for package in packages)


def _is(name: str, known: str) -> bool:
    return name.startswith(known.removesuffix(_ANY)) if known.endswith(_ANY) else name == known
