"""Packages of Qt 5 that the headers of code alone ask for, where CMake requires Qt 4: their names are the same."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from roslab.evidence.dependency import Dependency
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_QT4 = "libqt4-dev"
_QT5 = pattern(r"(?:lib)?qt\w*5[\w-]*-dev")


def of_another_qt(
    guessed: Mapping[str, Dependency | Requirement], declared: Iterable[str], asked: Iterable[Dependency]
) -> frozenset[str]:
    """Return the guessed packages of Qt 5 of a tree that requires Qt 4, and for which no file of CMake has Qt 5."""
    if _QT4 not in declared or any(each.namespace == "cmake" and each.name.startswith("Qt5") for each in asked):
        return frozenset()
    by_header = (n for n, each in guessed.items() if isinstance(each, Dependency) and each.namespace == "include")
    return frozenset(name for name in by_header if _QT5.fullmatch(name))
