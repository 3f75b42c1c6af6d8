"""The toolkits of CUDA that Ubuntu has itself."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def host_compilers() -> dict[str, str]:
    """Return the newest compiler of C++ that the toolkit of each Ubuntu takes where Ubuntu's usual one is too new."""
    return {row["codename"]: row["compiler"] for row in rows("cuda_toolkits")}


@cache
def toolkits() -> dict[str, str]:
    """Return the version of the toolkit of each Ubuntu."""
    return {row["codename"]: row["toolkit"] for row in rows("cuda_toolkits")}


@cache
def toolkits_for_arm64() -> frozenset[str]:
    """Return the Ubuntus that have their toolkit for arm64, too; no other one is known to."""
    return frozenset(row["codename"] for row in rows("cuda_toolkits") if row["arm64"] == "yes")
