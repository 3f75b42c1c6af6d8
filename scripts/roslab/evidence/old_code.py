"""A use of something in C++ that newer releases of a package no longer have, in the sources of an extension."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class OldCode:
    """What one build script compiles and newer releases of a package do not."""

    script: str
    """Path of the setup.py."""
    package: str
    below: str
    """The first release that it does not compile with."""
    define: str
    """A macro with which it does, ``""`` where there is none."""
    what: str
    file: str
    line: int
