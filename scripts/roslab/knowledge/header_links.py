"""Headers of a package that contradict those of another where one file includes both: a link takes their place."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class HeaderLink:
    """A header to replace on an Ubuntu, and what code includes that then needs it."""

    ubuntu: str
    one: tuple[str, ...]
    """Beginnings of headers of which the code includes one."""
    other: tuple[str, ...]
    """Beginnings of headers of which it includes one, too."""
    file: str
    instead: str
    """The header that the link leads to, of which ``file`` is an older copy."""


@cache
def header_links() -> tuple[HeaderLink, ...]:
    """Return all rows."""
    return tuple(record(HeaderLink, row) for row in rows("header_links"))
