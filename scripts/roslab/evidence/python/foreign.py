"""Imports that mean a known package, and not the tree's folder of that name."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.evidence.python.namesakes import Namesakes
from roslab.repository.checkout import File
from roslab.values.pattern import pattern

_NAMES = pattern(r"[ \t]*(?:\(([^)]{0,2000})\)|([^\n#;]*))")


def foreign(match: re.Match[str], modules: Iterable[str], top: str, like: Namesakes, file: File) -> bool:
    """Tell whether a statement does not import the tree's folder ``top``; ``modules``: by their whole names."""
    if top not in like.found:
        return False
    named = [name for name in modules if name.partition(".")[0] == top]
    elsewhere = any(like.foreign(name, file) for name in named)
    return elsewhere or (top in named and like.without(top, _taken(match, top), file))


def _taken(match: re.Match[str], top: str) -> frozenset[str]:
    """Return what the file of a statement takes of a module: ``Serial`` of ``serial.Serial(port)``."""
    if match["module"]:
        listed = _NAMES.match(match.string, match.end())
        words = (listed[1] or listed[2] or "").split(",") if listed else []
        return frozenset(word.split()[0] for word in words if word.split() and word.strip() != "*")
    alias = re.search(rf"\b{top}[ \t]+as[ \t]+(\w+)", match["plain"])
    used = re.compile(rf"(?<![\w.]){alias[1] if alias else top}\.([A-Za-z_]\w*)")
    return frozenset(used.findall(match.string))
