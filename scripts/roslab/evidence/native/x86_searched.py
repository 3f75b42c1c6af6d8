"""Libraries for x86-64 in folders of the tree where CMake looks for them by their names."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Collection, Iterator

from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.x86 import cmake_files
from roslab.knowledge.libraries import library
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

FINDING = frozenset({"find_library", "link_directories", "target_link_directories"})
_ASKING = frozenset({"find_package", "find_dependency"})
_ROOT = pattern(r"\$\{(?:(?:PROJECT|CMAKE|CMAKE_CURRENT|\w+)_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR)\}(?:/|$)")
_OPTION = pattern(r"[A-Z][A-Z_]{3,}$")
_FINDS = pattern(r"Find(\w+)\.cmake$")


def searched(
    call: Call,
    file: File,
    names: Collection[str],
    text: str,
    repository: Repository,
    *,
    is_x86: Callable[[str, Repository], bool],
) -> str | None:
    """Return the library that a call finds in the tree, or that is linked by its name from a folder that it names.

    ``names``: what the file links. One that CMake would find in the system first is none.
    """
    if call.name != "find_library":
        folders, looked_for = call.words, list(names)
    else:
        if not _used(call, file, text, repository):
            return None
        folders, looked_for = call.words[1:], list(wanted(call))
        first = "NO_DEFAULT_PATH" in call.words or "HINTS" in call.words
        if not first and any(library("link", name, None) for name in looked_for):
            return None
    for path in _paths(folders, looked_for, file):
        if repository.has(path) and is_x86(path, repository):
            return path
    return None


def wanted(call: Call) -> Iterator[str]:
    """Yield the names that a search is for: those after ``NAMES``, or the words before the first option."""
    words = call.words[1:]
    for word in words[1:] if words[:1] == ("NAMES",) else words:
        if _OPTION.match(word):
            return
        yield word


def _paths(folders: Collection[str], names: Collection[str], file: File) -> Iterator[str]:
    """Yield the paths where a library of such a name would lie in the tree."""
    for folder in folders:
        inside = _ROOT.sub("", folder, count=1)
        if "$" in inside or inside.startswith("/") or _OPTION.match(folder):
            continue
        for above in dict.fromkeys((file.folder, "")) if _ROOT.match(folder) else (file.folder,):
            place = posixpath.normpath(posixpath.join(above, inside))
            for name in names:
                plain = name.removeprefix("-l")
                yield from (f"{place}/{each}" for each in (plain, f"lib{plain}.so", f"lib{plain}.a"))


def _used(call: Call, file: File, text: str, repository: Repository) -> bool:
    """Tell whether what a search finds is linked, or what a module finds is asked for by its name."""
    if not (match := _FINDS.match(file.name)):
        return f"${{{call.words[0]}}}" in text
    asking = (call for each in cmake_files(repository) for call in calls(repository.read(each), _ASKING))
    return any(match[1] in call.words[:1] for call in asking)
