"""Libraries that a setup.py links by their files below /usr/local: only what is built by hand lies there."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
_FILE = pattern(r"^[^#\n]*?[\"']/usr/local/lib/(?:[\w+-]+/)?lib([A-Za-z][\w+-]*)\.(?:so|a)[\"']", re.MULTILINE)
"""The first on its line."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return each such library of each setup.py once."""
    found: dict[tuple[str, str], Dependency] = {}
    for file in repository.named("setup.py"):
        if places.aside(file.path) or file.size > MAX_SIZE:
            continue
        text = repository.read(file)
        for match in _FILE.finditer(text) if "Extension(" in text else ():
            line = text.count("\n", 0, match.start()) + 1
            asked = Dependency(
                namespace="link", name=match[1], strength="declared", file=file.path, line=line, role="setup"
            )
            found.setdefault((file.path, match[1]), asked)
    return tuple(found.values())
