"""What can be started."""

from __future__ import annotations

from typing import Literal

from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Program:
    """A Python program that can be started: it has a ``__main__`` guard, or statements at its top."""

    file: str
    line: int
    kind: Literal["main", "console", "node"]
    inside: str = ""
    """The folder that it has to be started in, by what it puts on Python's path."""
    guarded: bool = True
    """It has such a guard; else its statements run whenever it is imported."""
    imported: bool = False
    """Another module of the tree imports it."""
    module: str = ""
    """The package that ``python -m`` starts by it, of a ``__main__.py``: from above its folder, or of ``src``."""
    relative: bool = False
    """It imports what lies beside it by a dot, which Python refuses to a file that is started by its path."""
