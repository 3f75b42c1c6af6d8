"""The options of CMake that somebody sets or that nobody sets: what waits for one that is off is not built."""

from __future__ import annotations

import re

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_OFF = pattern(r"(?:^| AND )OFF (\w+)")

_ON = pattern(r"(?:^| AND )ON (\w+)")


def given(evidence: Evidence) -> str:
    """Return the options that pages at the root give CMake, one after the other."""
    return " ".join(m.text for m in evidence.mentions if m.topic == "compiled" and "/" not in m.file)


def waits(dependency: Dependency, options: str) -> bool:
    """Tell whether CMake looks for it only where an option is set which is off and is none of those given."""
    return any(f"-D{name}" not in options for name in _off(dependency.condition or ""))


def _off(condition: str) -> list[str]:
    """Return the options that are off in a condition; most conditions have none."""
    return _OFF.findall(condition) if "OFF " in condition else []


def switched_off(dependency: Dependency, options: str) -> bool:
    """Tell whether CMake looks for it only where an option is set that is on, and one of those given turns it off."""
    names = _ON.findall(dependency.condition) if options and dependency.condition else ()
    return any(re.search(rf"-D{name}(?::\w+)?=(?:OFF|FALSE|NO|0)\b", options, re.IGNORECASE) for name in names)


def switched_on(dependency: Dependency, options: str) -> bool:
    """Tell whether CMake looks for it under an option that one of those given turns on, and under nothing else."""
    names = (part.rpartition(" ")[2] for part in (dependency.condition or "").split(" AND "))
    on = r"(?::\w+)?=(?:ON|TRUE|YES|1)\b"
    return all(name.isidentifier() and re.search(rf"-D{name}{on}", options, re.IGNORECASE) for name in names)


def switch_of(dependency: Dependency, options: str) -> str:
    """Return the innermost option that is on and without which CMake does not look for it; ``""`` if one is given."""
    names = _ON.findall(dependency.condition or "")
    return "" if any(f"-D{name}" in options for name in names) else next(reversed(names), "")
