"""Programs that CMake files call while they configure or build, and the apt packages that they need."""

from __future__ import annotations

from functools import cache

from roslab.knowledge.table import rows


@cache
def packages_of_calls() -> dict[str, tuple[str, ...]]:
    """Return the packages by the name of the program or script."""
    return {row["called"]: tuple(row["apt"].split()) for row in rows("cmake_calls")}


def lines_of_calls() -> str:
    """Return lines ``run:NAME... = PACKAGE...``, names in lower case, as the scripts of the image read them."""
    names: dict[tuple[str, ...], list[str]] = {}
    for name, packages in packages_of_calls().items():
        names.setdefault(packages, []).append(f"run:{name.lower()}")
    return "".join(f"{' '.join(of)} = {' '.join(packages)}\n" for packages, of in names.items())
