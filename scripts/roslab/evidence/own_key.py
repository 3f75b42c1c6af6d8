"""A key for rosdep that the repository itself defines."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class OwnKey:
    """A key of a list for rosdep, with Ubuntu's packages for it."""

    name: str
    apt: tuple[tuple[str, tuple[str, ...]], ...]
    """``(release, packages)``: a codename, a version such as ``18.04``, or ``*`` for every other release."""
    file: str
    line: int
