"""The toolkits of CUDA that Ubuntu has itself."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def host_compilers() -> dict[str, str]:
    """Return the newest compiler of C++ that the toolkit of each Ubuntu takes where Ubuntu's usual one is too new."""
    return {row["codename"]: row["compiler"] for row in rows("cuda_toolkits")}
