"""Modules of Python that lie in the tree compiled, without their source: each is for one Python."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

_MODULE = pattern(r"\w+\.cpython-([23])(\d{1,2})[a-z]?-\w+-linux-gnu\w*\.so")
"""https://peps.python.org/pep-3149/, read 2026-11-27."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the Python that all such modules for Linux are compiled for, at the one nearest to the root."""
    found: dict[str, File] = {}
    for file in nearest(repository.suffixed(".so")):
        match = _MODULE.fullmatch(file.name)
        if match and not places.aside(file.path):
            found.setdefault(f"{match[1]}.{match[2]}", file)
    if len(found) == 1:
        ((version, file),) = found.items()
        yield Mention(topic="compiled_for", value=version, source="code", file=file.path, line=1, text=file.name)
