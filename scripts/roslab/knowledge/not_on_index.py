"""Names that people require and pip's index does not have, or has only to raise an error."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from packaging.utils import canonicalize_name

from roslab.knowledge.table import rows


@dataclass(frozen=True, kw_only=True, slots=True)
class NotOnIndex:
    """What to install instead (``""`` where nothing can be), and why."""

    instead: str
    why: str
    source: str
    """Where its author tells how to install it."""


@cache
def not_on_index() -> dict[str, NotOnIndex]:
    """Return the table, by names as the index compares them."""
    return {
        canonicalize_name(row["pip"]): NotOnIndex(instead=row["instead"], why=row["why"], source=row["source"])
        for row in rows("not_on_index")
    }
