"""Folders of the author's own computer that CMake adds, and libraries there that it links, in any case.

It stops there on every other computer.
"""

from __future__ import annotations

import posixpath

from roslab.evidence.lex.cmake import calls
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_ELSEWHERE = pattern(r"/(?:home|Users|root|mnt|media)/[^$<>]+")
LIBRARY = pattern(r".*\.(?:a|so(?:\.[\d.]+)?)")
_LINKING = frozenset({"target_link_libraries", "link_libraries"})
_OPTIONAL = frozenset({"OPTIONAL", "RESULT_VARIABLE"})


def authors_parts(text: str, repository: Repository) -> tuple[tuple[str, int], ...]:
    """Return what a CMakeLists.txt adds, includes or links from there, each with its line.

    Not what waits for a condition, what a variable says that the call of CMake may set, nor what the tree has: a link
    may lead to that. https://cmake.org/cmake/help/latest/command/include.html, read 2026-11-27.
    """
    if not any(f"/{folder}/" in text for folder in ("home", "Users", "root", "mnt", "media")):
        return ()
    found: dict[str, int] = {}
    kept: set[str] = set()
    for call in calls(text, frozenset({"set", "add_subdirectory", "include", *_LINKING})):
        if call.name == "set":
            kept |= {call.words[0]} if "CACHE" in call.written else set()
            continue
        if call.conditions or call.in_function or not call.words:
            continue
        links = call.name in _LINKING
        written = call.written[:1] if not links else call.written
        given = any(each.startswith("${") and each[2:].partition("}")[0] in kept for each in written)
        optional = call.name == "include" and not _OPTIONAL.isdisjoint(call.words)
        for path in () if optional or given else call.words if links else call.words[:1]:
            meant = _ELSEWHERE.fullmatch(path) and (not links or LIBRARY.fullmatch(path))
            if meant and not _there(path, repository):
                found.setdefault(posixpath.normpath(path), call.line)
    return tuple(found.items())


def _there(path: str, repository: Repository) -> bool:
    """Tell whether the tree has what a path from above it names."""
    parts = [part for part in path.split("/") if part][2:]
    return any(repository.may_have("/".join(parts[at:])) for at in range(len(parts)))
