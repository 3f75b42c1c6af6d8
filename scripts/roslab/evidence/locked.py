"""What a lock tells of one release."""

from __future__ import annotations

from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class Locked:
    """A release that a lock names, with the condition under which it is meant as its marker."""

    requirement: Requirement
    """``torch==2.7.1+cu128``."""
    wheels: tuple[str, ...]
    """The file names of its wheels."""
    needs: tuple[str, ...]
    """The normalised names of what it needs."""
    elsewhere: bool = False
    """It comes from another index than most of the lock."""
