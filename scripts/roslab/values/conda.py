"""A package as conda is asked for it: ``channel::name=version=build``, which is no requirement of pip's.

https://docs.conda.io/projects/conda/en/stable/user-guide/concepts/pkg-specs.html#package-match-specifications.
No library reads these without conda itself.
"""

from __future__ import annotations

import re
from typing import NamedTuple

_MATCH = re.compile(
    r"(?:[^\s:]+::)?(?P<name>\w[\w.-]*)(?:\s*(?P<sign>[=<>~!]*)\s*(?P<version>\d[\w.+-]*)(?P<build>=[\w.]+$)?)?"
    r"(?:[\s=<>~!,.*|\[].*)?"
)
_EXACT = frozenset({"=", "==", "~="})


class CondaPackage(NamedTuple):
    """One package of an environment or of an install line."""

    name: str
    """Lower case, with dashes, without its channel."""
    sign: str
    """``=``, ``>=`` …; ``""`` before a version that a space divides from the name."""
    version: str
    """The first that is named, ``""`` for none."""
    build: str
    """``py38_0``: such a line names a build for one platform."""
    written: str

    @property
    def release(self) -> str | None:
        """The version that it is pinned to."""
        return self.version if self.version and self.sign in _EXACT else None


def conda_package(text: str) -> CondaPackage | None:
    """Read one match specification, ``None`` where it names nothing."""
    match = _MATCH.fullmatch(text.strip())
    if match is None:
        return None
    name = match["name"].lower().replace("_", "-")
    version = (match["version"] or "").rstrip(".")
    return CondaPackage(name, match["sign"] or "", version, (match["build"] or "").removeprefix("="), text.strip())
