"""A path that a CMakeLists.txt installs."""

from __future__ import annotations

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class InstalledPath:
    """A file or a folder that is installed whatever the conditions are."""

    path: str
    """From the repository's root."""
    folder: bool
    line: int
