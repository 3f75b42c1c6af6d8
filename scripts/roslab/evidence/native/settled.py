"""Variables of CMake that the tree sets itself: who gives one of them overrides what its author looked for before."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WORD = pattern(r"[^\s(]+")


def settled(names: Iterable[str], repository: Repository) -> tuple[str, ...]:
    """Return those that a file of CMake sets, but for defaults: in the cache, or where it has no value."""
    asked = sorted(set(names))
    texts = repository.once(_texts) if asked else []
    words = repository.once(_words) if asked else frozenset()
    return tuple(name for name in asked if name.lower() in words and _set(name, texts))


def _texts(repository: Repository) -> list[str]:
    return [repository.read(file) for file in cmake_files(repository)]


def _words(repository: Repository) -> frozenset[str]:
    """Return what stands behind blanks and brackets in the files, in lower case: of many names asked for few do."""
    return frozenset().union(*(_WORD.findall(text.lower()) for text in repository.once(_texts)))


def _set(name: str, texts: Iterable[str]) -> bool:
    sets = re.compile(rf"^[^#\n]*\bset\s*\(\s*{name}\s(?![^)]*\bCACHE\b)", re.IGNORECASE | re.MULTILINE)
    default = re.compile(rf"\bNOT\s+(?:DEFINED\s+)?{name}\b")
    found = [text for text in texts if name in text]
    return any(sets.search(text) for text in found) and not any(default.search(text) for text in found)
