"""Python modules that the source of a library holds: pip installs them from where its recipe puts them."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class LibraryModules:
    """The modules of one library."""

    library: str
    """Its row in ``recipes.toml``."""
    modules: tuple[str, ...]
    pip: str
    """Their package, which no index has."""
    installs: str
    """What pip is asked for, once the library is in the image."""
    variables: tuple[str, ...]
    """``NAME=VALUE``, with which programs and build files find it."""
    source: str


@cache
def library_modules() -> tuple[LibraryModules, ...]:
    """Return all rows."""
    return tuple(record(LibraryModules, row) for row in rows("library_modules"))
