"""Limits that old releases of packages need and do not declare: pip installs with them what came later."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.record import grouped
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


@dataclass(frozen=True, kw_only=True, slots=True)
class UndeclaredLimit:
    """What the releases of a package before one need of another package."""

    below: Version | None
    """``None`` where all releases need it."""
    released: str
    """The day of that release, ``""`` where what it limits was released after it: on no day pip took both."""
    limit: Requirement
    conda: str
    """The limit in conda's words, whose packages have names with underscores too."""


@cache
def undeclared_limits() -> dict[str, tuple[UndeclaredLimit, ...]]:
    """Return the table by the normalised name of the package."""
    return grouped(
        (
            canonicalize_name(row["package"]),
            UndeclaredLimit(
                below=Version(row["below"]) if row["below"] else None,
                released=row["released"],
                limit=(limit := stated(row["limit"])),
                conda=_conda(row, limit),
            ),
        )
        for row in rows("undeclared_limits")
    )


def _conda(row: dict[str, str], limit: Requirement) -> str:
    return f"{row['conda'] or limit.key}{limit.specifier}"
