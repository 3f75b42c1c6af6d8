"""Version specifiers as people write them, repaired where needed and parsed by ``packaging``."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from operator import ge, gt, le, lt
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.version import Version

if TYPE_CHECKING:
    from packaging.specifiers import SpecifierSet

NEWEST_PATCH = 99
"""Above every patch release of a Python: 3.8 ended at 3.8.20, 3.9 at 3.9.25. https://www.python.org/downloads/."""
_SERIES = pattern(r"([~^])\s*(\d+(?:\.\d+)*)")
_ONE = r"(?:[<>]=?\s*\d+(?:\.\d+)*|[=!]=\s*\d+(?:\.\d+)*(?:\.\*)?|~=\s*\d+(?:\.\d+)+)"
PLAIN = rf"(?:{_ONE}(?:\s*,\s*{_ONE})*)?"
"""Specifiers of which every version is numbers alone."""
_PLAIN = pattern(rf"\s*{PLAIN}\s*")
_PART = pattern(r"([<>=!~]+)\s*([\d.*]+)")
_NUMBERS = pattern(r"\d+(?:\.\d+)*")


_ORDERS: dict[str, Callable[[Any, Any], bool]] = {">=": ge, "<=": le, ">": gt, "<": lt}


class Part(NamedTuple):
    """One specifier, as ``packaging`` names its parts."""

    operator: str
    version: str

    def __str__(self) -> str:
        return f"{self.operator}{self.version}"


@dataclass(frozen=True)
class Specifiers:
    """Specifiers whose versions are numbers alone, as most are: ``packaging``'s are slow to import.

    They are used alike. https://packaging.python.org/en/latest/specifications/version-specifiers/
    """

    parts: tuple[Part, ...] = ()

    def __iter__(self) -> Iterator[Part]:
        return iter(self.parts)

    def __len__(self) -> int:
        return len(self.parts)

    def __str__(self) -> str:
        return ",".join(sorted(set(map(str, self.parts))))

    def contains(self, version: str, *, prereleases: bool | None = None) -> bool:
        """Tell whether a version is allowed; ``prereleases`` are if asked for or if nothing else is there."""
        if _NUMBERS.fullmatch(version):
            return all(_allows(part, version) for part in self.parts)
        from packaging.specifiers import SpecifierSet  # noqa: PLC0415 - slow to import

        return SpecifierSet(str(self)).contains(version, prereleases=prereleases)


Allowed: TypeAlias = "Specifiers | SpecifierSet"
"""The versions that are allowed; both kinds list their parts and answer ``contains``."""


def _allows(part: Part, version: str) -> bool:
    """Tell whether a part allows a version, both numbers alone: missing ones are 0."""
    bound, found = _release(part.version.removesuffix(".*")), _release(version)
    series = len(bound) - (part.operator == "~=") if part.operator == "~=" or part.version.endswith("*") else 0
    longest = max(len(bound), len(found))
    bound, found = (numbers + (0,) * (longest - len(numbers)) for numbers in (bound, found))
    if part.operator in _ORDERS:
        return _ORDERS[part.operator](found, bound)
    same = found[:series] == bound[:series] if series else found == bound
    if part.operator == "~=":
        return same and found >= bound
    return same == (part.operator == "==")


def _release(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def specifiers(text: str) -> Allowed | None:
    """Parse a list of specifiers, ``None`` if ``packaging`` cannot read it even after the repairs.

    Repaired are: a bare number (``3.8`` and conda's ``=3.8`` are ``==3.8.*``), a number with ``.*`` after an order
    (``>=3.6.*``, which pip took until version 24.1), and Poetry's ``^3.8`` and ``~3.8``.
    https://python-poetry.org/docs/dependency-specification/.
    """
    if _PLAIN.fullmatch(text):
        return Specifiers(tuple(Part(*found.groups()) for found in _PART.finditer(text)))
    from roslab.values.standard_requirement import InvalidSpecifier, SpecifierSet  # noqa: PLC0415 - slow to import

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
    from roslab.values.standard_requirement import InvalidSpecifier, Specifier  # noqa: PLC0415

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
def admits(allowed: Allowed, python: str) -> bool:
    """Tell whether any patch release of a Python (``3.8``) is allowed: an image takes the newest that is.

    It is enough to test the first, the newest, and the neighbours of every patch that the specifiers name.
    """
    named = {Version(specifier.version.removesuffix(".*")).micro for specifier in allowed}
    beside = {micro + step for micro in named for step in (-1, 0, 1) if micro + step > 0}
    return any(allowed.contains(f"{python}.{patch}") for patch in (0, NEWEST_PATCH, *beside))
