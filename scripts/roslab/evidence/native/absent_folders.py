"""Folders that CMake adds in any case and that the tree does not have: it stops there."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from itertools import islice

from roslab.evidence.git_modules import FILE, entries
from roslab.evidence.lex.cmake import calls
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

_ADDS = frozenset({"add_subdirectory"})
_BRINGS = pattern(
    r"\b(?:execute_process|FetchContent\w*|ExternalProject\w*|CPM\w*|file\s*\(\s*(?:DOWNLOAD|WRITE|COPY|MAKE_DIRECTORY|"
    r"ARCHIVE_EXTRACT)|configure_file|git)\b",
    re.IGNORECASE,
)
"""What may bring a folder before it is added."""
_PLAIN = pattern(r"[\w.-]+(?:/[\w.-]+)*/?")
_TOLD = (".md", ".rst", ".txt", ".sh", ".repos", ".rosinstall", ".yml", ".yaml")
MAX_FILES = 200
"""Most pages, scripts and lists that are searched, those nearest to the root first."""
MAX_SIZE = 128 * 1024
MAX_FOLDERS = 20
"""Most folders of one file for which they are searched."""
_FETCHES = ("git clone", "wget ", "curl ", "unzip", "submodule", "vcs import", "ln -s")


def absent_folders(text: str, path: str, repository: Repository) -> tuple[tuple[str, int], ...]:
    """Return the first, by its path in the tree, with its line in the CMakeLists.txt at ``path``.

    Not what a page may have the reader bring, nor what lies above the file: that may be in another repository.
    https://cmake.org/cmake/help/latest/command/add_subdirectory.html, read 2026-11-28.
    """
    if "add_subdirectory" not in text.lower() or _BRINGS.search(text):
        return ()
    absent = islice(_absent(text, path, repository), MAX_FOLDERS)
    return next((((folder, line),) for folder, line in absent if not _brought(folder, repository)), ())


def _absent(text: str, path: str, repository: Repository) -> Iterator[tuple[str, int]]:
    for call in calls(text, _ADDS, repeated=_ADDS):
        word = call.words[0] if call.words and not (call.conditions or call.in_function) else ""
        folder = posixpath.normpath(posixpath.join(posixpath.dirname(path), word))
        if word and not word.startswith("..") and _PLAIN.fullmatch(word) and not repository.may_have(folder):
            yield folder, call.line


def _brought(folder: str, repository: Repository) -> bool:
    """Tell whether a submodule, or what a page or a script fetches, may lie there, or around it."""
    parts = folder.split("/")
    around = ["/".join(parts[: end + 1]) for end in range(len(parts))]
    absent = [part for part, path in zip(parts, around, strict=True) if path not in repository.folders]
    name = re.compile(rf"(?<![\w-])(?:{'|'.join(map(re.escape, absent))})(?![\w-])")
    modules = repository.read(FILE) if repository.has(FILE) else ""
    if name.search(modules) or not {each.path for each in entries(modules)}.isdisjoint(around):
        return True
    return any(name.search(text) for text in repository.once(_fetching) if any(part in text for part in absent))


def _fetching(repository: Repository) -> tuple[str, ...]:
    """Return the pages, lists and scripts that fetch something."""
    files = nearest(file for file in repository.suffixed(*_TOLD) if file.size <= MAX_SIZE)[:MAX_FILES]
    texts = (repository.read(file) for file in files)
    return tuple(text for text in texts if any(sign in text for sign in _FETCHES))
