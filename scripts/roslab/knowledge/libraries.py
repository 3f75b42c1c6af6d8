"""Names of libraries, as CMake, pkg-config, the linker and the compiler call them, and the packages that hold them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Literal

from roslab.knowledge.table import rows

Naming = Literal["cmake", "pkg-config", "link", "include"]
_TABLES: dict[Naming, tuple[str, str]] = {
    "cmake": ("cmake", "name"),
    "pkg-config": ("pkg_config", "module"),
    "link": ("links", "name"),
    "include": ("includes", "header"),
}


@dataclass(frozen=True, kw_only=True, slots=True)
class Library:
    """Where a library comes from; all three may be empty, where the compiler or CMake itself brings it."""

    apt: tuple[str, ...] = ()
    ros: str = ""
    """A ROS package that holds it, preferred where the image has ROS."""
    beside: tuple[str, ...] = ()
    """What code that uses it usually needs too: headers it exposes, what its own build looks for."""
    recipe: str = ""
    """A row of ``recipes.toml`` that builds it, where no package holds it."""


@cache
def _table(naming: Naming) -> dict[str, list[tuple[tuple[str, ...], Library]]]:
    """Return the rows by name; those for some releases of Ubuntu stand before that for all others."""
    name, key = _TABLES[naming]
    found: dict[str, list[tuple[tuple[str, ...], Library]]] = {}
    for row in rows(name):
        library = Library(
            apt=tuple(row["apt"].split()),
            ros=row.get("ros", ""),
            recipe=row.get("recipe", ""),
            beside=tuple(row.get("beside", "").split()),
        )
        found.setdefault(row[key], []).append((tuple(row["ubuntu"].split()), library))
    for entries in found.values():
        entries.sort(key=lambda entry: not entry[0])
    return found


def library(naming: Naming, name: str, ubuntu: str | None) -> Library | None:
    """Return where a library comes from on an Ubuntu; ``None`` for a name that no table has.

    A name that is known but has no row for this Ubuntu gives an empty ``Library``.
    """
    entries = _table(naming).get(name)
    if entries is None:
        return None
    return next((found for releases, found in entries if not releases or ubuntu in releases), Library())


def header(path: str, ubuntu: str | None) -> Library | None:
    """Return what an included header comes from: by its whole path, or by the folder it begins with."""
    parts = path.split("/")
    for length in range(len(parts), 0, -1):
        stem = "/".join(parts[:length]) + ("/" if length < len(parts) else "")
        if (found := library("include", stem, ubuntu)) is not None:
            return found
    return None
