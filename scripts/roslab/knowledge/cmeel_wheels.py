"""Wheels that hold a library of C++ with its packages of CMake, made by cmeel: below ``cmeel.prefix``, beside modules.

https://github.com/cmake-wheel/cmeel, read 2026-11-28
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def cmeel_wheels() -> dict[str, frozenset[str]]:
    """Return for each package of pip what CMake finds with its extra ``build``, in lower case with ``-``."""
    return _with_required("brings")


@cache
def header_folders() -> dict[str, frozenset[str]]:
    """Return for each package of pip the folders of headers that are not called as what CMake finds."""
    return _with_required("headers")


@cache
def by_conda() -> dict[str, str]:
    """Return the wheel of each package of conda-forge that has the same library."""
    return {row["conda"]: row["pip"] for row in rows("cmeel_wheels")}


def _with_required(column: str) -> dict[str, frozenset[str]]:
    """Return the words of a column with those of the wheels that a wheel requires, which stand above it."""
    found: dict[str, frozenset[str]] = {}
    for row in rows("cmeel_wheels"):
        required = (found[pip] for pip in row["requires"].split())
        found[row["pip"]] = frozenset(row[column].split()).union(*required)
    return found
