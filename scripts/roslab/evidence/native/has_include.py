"""The libraries of which code asks whether a header is there: it then compiles with more than one release of them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from roslab.knowledge.code_limits import OF_ROS2, limits
from roslab.values.pattern import pattern

HAS_INCLUDE = "__has_include"
_HEADER = pattern(r"__has_include(?:_next)?\s*\(\s*[<\"]([\w./+-]+)[>\"]")
_COMPILER = "GCC"
"""Of which release a standard header asks, the code around it needs all the same."""


def asked_for(text: str) -> Iterator[str]:
    """Yield the libraries, as the table of signs has them; all of them where a header is not written out."""
    headers = {match[1] for match in _HEADER.finditer(text)}
    if not headers:
        yield from _begins()
    for folder in {header.lower().partition("/")[0].partition(".")[0] for header in headers}:
        yield from (library for library, begins in _begins().items() if _alike(folder, begins))


def _alike(folder: str, begins: frozenset[str]) -> bool:
    return any(folder.startswith(each) or each.startswith(folder) for each in begins)


@cache
def _begins() -> dict[str, frozenset[str]]:
    """Return how the headers of each library begin: with its own name, or with what its signs are."""
    found: dict[str, set[str]] = {}
    for limit in limits():
        if limit.library != _COMPILER:
            begins = found.setdefault(limit.library, {limit.library.removeprefix(OF_ROS2).lower()})
            if limit.where == "include":
                begins.update(part.lower().partition("/")[0] for part in limit.hints.each)
    return {library: frozenset(filter(None, begins)) for library, begins in found.items()}
