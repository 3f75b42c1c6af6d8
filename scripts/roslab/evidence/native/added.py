"""What holds of a project of CMake for being added by another one."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.evidence.lex.cmake import NOTHING
from roslab.values.dataclass import dataclass, field


@dataclass(kw_only=True, slots=True)
class Added:
    """What holds where a folder is added."""

    options: dict[str, bool] = field(default_factory=dict)
    """Those that are declared, and whether each is on."""
    switches: tuple[str, ...] = ()
    """The conditions that an option decides."""
    by_tool: tuple[str, ...] = ()
    """Those that the build tool decides."""
    unset: tuple[str, ...] = ()
    """Those of one variable that is no declared option."""
    names: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: NOTHING)
    """What variables call the project that adds it and the whole."""
    within: bool = False
    """It is a part of a project that is not about tests alone."""
    top: str | None = None
    """The folder of the first file of those that add it."""
    always: bool = False
    """No condition stands before it, nor before the one that adds it."""
    usual: bool = True
    """So is it in a usual build: where a condition stands before one of them, it is an option that is on."""
