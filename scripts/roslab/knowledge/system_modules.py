"""The versions of modules of Python that Ubuntus have, where code often uses what older ones lack."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class SystemModule:
    """The package of one Ubuntu."""

    version: str
    below: str
    """The first release of pip's that does not take the Ubuntu's own NumPy, ``""`` where none is known."""


@cache
def system_modules() -> dict[tuple[str, str], SystemModule]:
    """Return the packages by the Ubuntu and the module."""
    return {
        (row["ubuntu"], row["module"]): SystemModule(version=row["version"], below=row["below"])
        for row in rows("system_modules")
    }
