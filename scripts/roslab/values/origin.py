"""Where a value comes from: a place in a file, an input of the action or of a workflow, an option of the command."""

from __future__ import annotations

from typing import ClassVar

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Place:
    """A place in a file of the repository; line and column count from 1, ``None`` if the whole file is meant."""

    file: str
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        return ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)


@dataclass(frozen=True, kw_only=True, slots=True)
class Input:
    """An input of the action or of a callable workflow, by its name: ``build-tool``."""

    name: str
    file: ClassVar[None] = None
    line: ClassVar[None] = None
    column: ClassVar[None] = None

    def __str__(self) -> str:
        return f"input {self.name}"


@dataclass(frozen=True, kw_only=True, slots=True)
class Option:
    """An option of the command line, as it is typed: ``--platform``."""

    name: str
    file: ClassVar[None] = None
    line: ClassVar[None] = None
    column: ClassVar[None] = None

    def __str__(self) -> str:
        return self.name


Origin = Place | Input | Option
"""Any origin; ``str`` names it, and ``file``, ``line`` and ``column`` are ``None`` outside files."""
