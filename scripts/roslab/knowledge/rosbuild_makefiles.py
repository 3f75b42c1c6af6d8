"""The programs that Makefiles of rosbuild clone with."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def _programs() -> dict[str, str]:
    return {row["makefile"]: row["apt"] for row in rows("rosbuild_makefiles")}


def program_of(makefile: str) -> str | None:
    """Return the package of the program that a Makefile of the package ``mk`` clones with: of ``git_checkout``, git."""
    return _programs().get(makefile)
