"""A package in conda's notation, ``channel::name=version=build``, which pip does not understand.

https://docs.conda.io/projects/conda/en/stable/user-guide/concepts/pkg-specs.html#package-match-specifications.
No library parses these without conda itself.
"""

from __future__ import annotations

from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_MATCH = pattern(
    r"(?:[^\s:]+::)?(?P<name>\w[\w.-]*)(?:\s*(?P<sign>[=<>~!]*)\s*(?P<version>\d[\w.+-]*)(?P<build>=[\w.]+$)?)?"
    r"(?:[\s=<>~!,.*|\[].*)?"
)
_EXACT = frozenset({"=", "==", "~="})


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


def conda_package(text: str) -> CondaPackage | None:
    """Read one match specification, ``None`` if it names no package."""
    match = _MATCH.fullmatch(text.strip())
    if match is None:
        return None
    name = match["name"].lower().replace("_", "-")
    version = (match["version"] or "").rstrip(".")
    return CondaPackage(name, match["sign"] or "", version, (match["build"] or "").removeprefix("="), text.strip())
