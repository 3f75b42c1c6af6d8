"""A use of a name that newer versions of a package no longer have."""

from __future__ import annotations

from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class Removed:
    """A use of a name that newer versions of a Python package no longer have."""

    bound: Requirement
    """The versions that still have it: ``matplotlib<3.5``."""
    what: str
    file: str
    line: int
