"""Folders that CMake adds in any case and that the tree does not have: it stops there."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence.git_modules import FILE
from roslab.evidence.lex.cmake import calls
from roslab.repository.checkout import Repository
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
MOST = 200
MAX_SIZE = 128 * 1024
_FETCHES = ("git clone", "wget ", "curl ", "unzip", "submodule", "vcs import", "ln -s")


def absent_folders(text: str, path: str, repository: Repository) -> Iterator[tuple[str, int]]:
    """Yield each, by its path in the tree, with its line in the CMakeLists.txt at ``path``.

    Not what a page may have the reader bring, nor what lies above the file: that may be in another repository.
    https://cmake.org/cmake/help/latest/command/add_subdirectory.html, read 2026-11-28.
    """
    if "add_subdirectory" not in text.lower() or _BRINGS.search(text):
        return
    for call in calls(text, _ADDS, repeated=_ADDS):
        word = call.words[0] if call.words and not (call.conditions or call.in_function) else ""
        folder = posixpath.normpath(posixpath.join(posixpath.dirname(path), word))
        if not word or word.startswith(("/", "..")) or not _PLAIN.fullmatch(word) or repository.may_have(folder):
            continue
        if not _brought(folder, repository):
            yield folder, call.line


def _brought(folder: str, repository: Repository) -> bool:
    """Tell whether a submodule, or what a page or a script fetches, may lie there."""
    name = re.compile(rf"(?<![\w-]){re.escape(posixpath.basename(folder))}(?![\w-])")
    if repository.has(FILE) and name.search(repository.read(FILE)):
        return True
    for file in repository.suffixed(*_TOLD)[:MOST]:
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        if any(sign in text for sign in _FETCHES) and name.search(text):
            return True
    return False
