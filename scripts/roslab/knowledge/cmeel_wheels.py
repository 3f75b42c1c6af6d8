"""Wheels that hold a library of C++ with its packages of CMake, made by cmeel: below ``cmeel.prefix``, beside modules.

https://github.com/cmake-wheel/cmeel, read 2026-11-28
"""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def cmeel_wheels() -> dict[str, frozenset[str]]:
    """Return for each package of pip what CMake finds with its extra ``build``, in lower case with ``-``."""
    return {row["pip"]: frozenset(row["brings"].split()) for row in rows("cmeel_wheels")}


@cache
def by_conda() -> dict[str, str]:
    """Return the wheel of each package of conda-forge that has the same library."""
    return {row["conda"]: row["pip"] for row in rows("cmeel_wheels")}
