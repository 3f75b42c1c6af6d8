"""Names that people require although pip's index lacks them, or has only a placeholder that raises an error."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name


@dataclass(frozen=True, kw_only=True, slots=True)
class NotOnIndex:
    """What to install instead (``""`` where nothing can be), and why."""

    instead: str
    why: str
    conda: tuple[str, ...]
    """conda's channels that have it."""
    source: str
    """Where its author tells how to install it."""


@cache
def not_on_index() -> dict[str, NotOnIndex]:
    """Return the table by normalised name."""
    return {canonicalize_name(row["pip"]): record(NotOnIndex, row) for row in rows("not_on_index")}


@cache
def of_ros() -> dict[str, NotOnIndex]:
    """Return ROS's own packages by normalised name: the index has none, or another thing of the name."""
    return {
        canonicalize_name(row["pip"]): record(NotOnIndex, row, instead="", why="it is a package of ROS's", conda=())
        for row in rows("of_ros")
    }
