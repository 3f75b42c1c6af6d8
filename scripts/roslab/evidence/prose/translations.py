"""Pages that say in another language what a page of the tree says: they are often older than it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from roslab.knowledge.page_languages import page_languages
from roslab.repository.checkout import File

LONGEST = 7
"""Letters of a code."""
ENGLISH = "en"
SMALLEST = 8
"""A page of less than this part of a translation's size only leads to it."""


def without_translations(pages: Iterable[File]) -> list[File]:
    """Return the pages without the translations of others among them."""
    pages = list(pages)
    originals = {_original(file.path): file.size for file in pages if not _translated(file.path)}
    return [
        file
        for file in pages
        if not _translated(file.path) or originals.get(_original(file.path), 0) * SMALLEST < file.size
    ]


def _translated(path: str) -> bool:
    return any(_split(part)[1] not in {"", ENGLISH} for part in _named(path))


def _original(path: str) -> str:
    """Return the path without languages: of ``docs_zh-CN/install.md`` and ``docs/en/install.md`` ``docs/install``."""
    return "/".join(name for part in _named(path) if (name := _split(part)[0]))


def _named(path: str) -> list[str]:
    return posixpath.splitext(path)[0].lower().split("/")


def _split(part: str) -> tuple[str, str]:
    """Return the name of a file or folder without its language, and that language, ``""`` if it names none."""
    for length in range(min(len(part), LONGEST), 1, -1):
        name, code = part[:-length], part[-length:].replace("_", "-")
        if (code == ENGLISH or code in page_languages()) and (not name or name[-1] in "-_."):
            return name.rstrip("-_."), code
    return part, ""
