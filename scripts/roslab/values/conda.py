"""A package in conda's notation, ``channel::name=version=build``, which pip does not understand.

https://docs.conda.io/projects/conda/en/stable/user-guide/concepts/pkg-specs.html#package-match-specifications.
No library parses these without conda itself.
"""

from __future__ import annotations

from collections.abc import Iterable

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.version import minor_of

_MATCH = pattern(
    r"(?:[^\s:]+::)?(?P<name>\w[\w.-]*)(?:\s*(?P<sign>[=<>~!]*)\s*(?P<version>\d[\w.+-]*)(?P<build>=[\w.]+$)?)?"
    r"(?:[\s=<>~!,.*|\[].*)?"
)
_EXACT = frozenset({"=", "==", "~="})
_NAMING = frozenset({"", "=", "=="})
"""What stands before a version that is named; every other sign bounds it."""


@dataclass(frozen=True, slots=True)
class CondaPackage:
    """One package of an environment or of an install line."""

    name: str
    """Lower case, with dashes, without its channel."""
    sign: str
    """``=``, ``>=`` …; ``""`` if the version follows the name after a space."""
    version: str
    """The first version that is named, ``""`` for none."""
    build: str
    """Build string, ``py38_0``: such a line fits only one platform."""
    written: str

    @property
    def release(self) -> str | None:
        """The version that it is pinned to."""
        return self.version if self.version and self.sign in _EXACT else None

    @property
    def bounds(self) -> str:
        """All that is said of its versions where the first sign is a bound, ``>=3.7,<3.9``; else ``""``."""
        if not self.version or self.sign in _NAMING:
            return ""
        return "".join(self.written[self.written.index(self.sign) :].split())


def named_python(packages: Iterable[CondaPackage]) -> str | None:
    """Return the Python that an environment names, ``3.8``; ``None`` for none, and for one that it only bounds."""
    named = next((each for each in packages if each.name == "python" and each.version), None)
    return minor_of(named.version) if named and named.sign in _NAMING else None


def conda_package(text: str) -> CondaPackage | None:
    """Read one match specification, ``None`` if it names no package."""
    match = _MATCH.fullmatch(text.strip())
    if match is None:
        return None
    name = match["name"].lower().replace("_", "-")
    version = (match["version"] or "").rstrip(".")
    return CondaPackage(name, match["sign"] or "", version, (match["build"] or "").removeprefix("="), text.strip())
