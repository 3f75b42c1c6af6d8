"""Packages whose versions have more numbers than people write: ``opencv-python==4.2.0`` is ``4.2.0.32`` and later."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.version import Version


@dataclass(frozen=True, kw_only=True, slots=True)
class Numbered:
    """How many numbers the versions of a package have, from which one on."""

    numbers: int
    since: Version


@cache
def numbered() -> dict[str, Numbered]:
    """Return the table by normalised name."""
    return {
        row["pip"]: Numbered(numbers=int(row["numbers"]), since=Version(row["since"])) for row in rows("short_pins")
    }
