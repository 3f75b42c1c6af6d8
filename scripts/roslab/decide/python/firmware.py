"""Imports of code for microcontrollers beside the robot's: what they name is in MicroPython, and in no image."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.dependency import Dependency
from roslab.knowledge.micropython_modules import micropython_modules


def without_firmware(unknown: Iterable[Dependency]) -> list[Dependency]:
    """Return the imports of no table without MicroPython's of files that import one which MicroPython alone has."""
    found = list(unknown)
    known = micropython_modules()
    files = {used.file for used in found if known.get(used.name)}
    return [used for used in found if not (used.name in known and used.file in files)]
