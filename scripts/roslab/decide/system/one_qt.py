"""Packages of Qt 5 that headers alone ask for where CMake requires Qt 4 or 6: their names are the same."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from roslab.evidence.dependency import Dependency
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_QT4 = "libqt4-dev"
_QT6 = "Qt6"
_QT5 = pattern(r"(?:lib)?qt\w*5[\w-]*-dev")


def of_another_qt(
    guessed: Mapping[str, Dependency | Requirement], declared: Iterable[str], asked: Iterable[Dependency]
) -> frozenset[str]:
    """Return the guessed packages of Qt 5 of a tree that requires another Qt, and for which no file of CMake has Qt 5.

    Its components bring their own headers: ``<QtQml/…>`` is in Qt6Qml.
    """
    named = {each.name[:3] for each in asked if each.namespace == "cmake"}
    if "Qt5" in named or not (_QT4 in declared or _QT6 in named):
        return frozenset()
    by_header = (n for n, each in guessed.items() if isinstance(each, Dependency) and each.namespace == "include")
    return frozenset(name for name in by_header if _QT5.fullmatch(name))
