"""Headers that have the name of a library which is linked by nothing but its name."""

from __future__ import annotations

import re
from collections.abc import Mapping

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def headers_by_name(evidence: Evidence) -> dict[str, tuple[int, str]]:
    """Return the headers that the code includes by how their names begin, ``box2d``: the first, with its number."""
    found: dict[str, tuple[int, str]] = {}
    for number, each in enumerate(evidence.code):
        if each.namespace == "include" and each.strength == "used" and not places.aside(each.file):
            found.setdefault(re.split(r"[/.]", each.name.lower(), maxsplit=1)[0], (number, each.name))
    return found


def shown_by(asked: Dependency, headers: Mapping[str, tuple[int, str]]) -> str:
    """Return a header that has the name of a library which is always linked: ``Box2D/Box2D.h`` of ``Box2D``."""
    if asked.namespace != "link" or asked.strength != "used" or asked.role == "test":
        return ""
    names = (asked.name.lower(), f"lib{asked.name.lower()}")
    return min((headers[name] for name in names if name in headers), default=(0, ""))[1]
