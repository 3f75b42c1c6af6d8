"""Version specifiers as people write them, repaired where needed and parsed by ``packaging``."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from packaging.version import Version

from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from packaging.specifiers import SpecifierSet

NEWEST_PATCH = 99
"""Above every patch release of a Python: 3.8 ended at 3.8.20, 3.9 at 3.9.25. https://www.python.org/downloads/."""
_SERIES = pattern(r"([~^])\s*(\d+(?:\.\d+)*)")


def specifiers(text: str) -> SpecifierSet | None:
    """Parse a list of specifiers, ``None`` if ``packaging`` cannot read it even after the repairs.

    Repaired are: a bare number (``3.8`` and conda's ``=3.8`` are ``==3.8.*``), a number with ``.*`` after an order
    (``>=3.6.*``, which pip took until version 24.1), and Poetry's ``^3.8`` and ``~3.8``.
    https://python-poetry.org/docs/dependency-specification/.
    """
    from packaging.specifiers import InvalidSpecifier, SpecifierSet  # noqa: PLC0415 - slow to import

    try:
        return SpecifierSet(text)
    except InvalidSpecifier:
        parts = [_repaired(part.strip()) for part in text.strip().strip("()").split(",") if part.strip()]
    return None if "" in parts else SpecifierSet(",".join(parts))


def _repaired(part: str) -> str:
    """Return one specifier in the grammar of PEP 440, ``""`` if it is none."""
    if series := _SERIES.fullmatch(part):
        return _series(series[1], series[2])
    number = part[1:] if part.startswith("=") and not part.startswith("==") else part
    bare = (f"=={number}" if number.endswith("*") else f"=={number}.*") if number[:1].isdigit() else ""
    return next(filter(_valid, (number, part.removesuffix(".*"), bare)), "")


def _valid(specifier: str) -> bool:
    from packaging.specifiers import InvalidSpecifier, Specifier  # noqa: PLC0415

    try:
        Specifier(specifier)
    except InvalidSpecifier:
        return False
    return True


def _series(sign: str, lowest: str) -> str:
    """Return the range of ``^1.2.3`` (the same first number that is not 0) or ``~1.2.3`` (the same second number)."""
    numbers = lowest.split(".")[:3]
    last = min(1, len(numbers) - 1)
    if sign == "^":
        last = next((index for index, number in enumerate(numbers) if int(number)), len(numbers) - 1)
    above = [*numbers[:last], str(int(numbers[last]) + 1)]
    return f">={lowest},<{'.'.join(above)}"


@cache
def admits(allowed: SpecifierSet, python: str) -> bool:
    """Tell whether any patch release of a Python (``3.8``) is allowed: an image takes the newest that is.

    It is enough to test the first, the newest, and the neighbours of every patch that the specifiers name.
    """
    named = {Version(specifier.version.removesuffix(".*")).micro for specifier in allowed}
    beside = {micro + step for micro in named for step in (-1, 0, 1) if micro + step > 0}
    return any(allowed.contains(f"{python}.{patch}") for patch in (0, NEWEST_PATCH, *beside))
