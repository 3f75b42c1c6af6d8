"""What a CMakeLists.txt installs or compiles and the tree lacks: git keeps no empty folder, nor what it ignores."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import islice, takewhile

from roslab.evidence import git_modules
from roslab.evidence.installed_path import InstalledPath
from roslab.evidence.lex.cmake import Call
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_KINDS = {"DIRECTORY": True, "FILES": False, "PROGRAMS": False}
"""What ``install`` takes by its path, and whether that is a folder.
https://cmake.org/cmake/help/latest/command/install.html, read 2026-11-26."""
_SHARED = "INSTALL_TO_SHARE"
"""What follows are folders.
https://github.com/ament/ament_cmake (ament_cmake_auto/cmake/ament_auto_package.cmake), 2026-11-26"""
_HERE = pattern(r"^\$\{CMAKE_CURRENT_SOURCE_DIR\}/")
_PROJECT = "${PROJECT_SOURCE_DIR}/"
_PATH = pattern(r"[\w.+@-]+(?:/[\w.+@-]+)*/?")
MAX_PATHS = 60
"""Most paths of one call, and files of code that the tree lacks or options that need such."""
_WRITES = pattern(
    r"\bfile\s*\(\s*(?:DOWNLOAD|MAKE_DIRECTORY|WRITE|APPEND|COPY|GENERATE|CONFIGURE|ARCHIVE_EXTRACT)\b"
    r"|\b(?:execute_process|configure_file|add_custom_command|ExternalProject_Add)\s*\(",
    re.IGNORECASE,
)
"""What may make a file or a folder before it is installed, and asks whether it is there."""
_COMPILES = pattern(r"\badd_(?:executable|library)\s{0,9}\(([^()]{0,4000})\)", re.IGNORECASE)


def installed(call: Call, folder: str, *, own: bool) -> Iterator[InstalledPath]:
    """Yield the paths that a call installs whatever the conditions are; ``folder`` is that of its file.

    ``own``: that is also the folder of the project, and of none that a file above it begins.
    """
    words, folders = call.words, True
    if call.conditions or call.in_function or not words:
        return
    if call.name == "install" and words[0] in _KINDS and "OPTIONAL" not in words:
        words, folders = words[1:], _KINDS[words[0]]
    elif call.name == "ament_auto_package" and _SHARED in words:
        words = words[words.index(_SHARED) + 1 :]
    else:
        return
    for word in list(takewhile(lambda each: not _keyword(each), words))[:MAX_PATHS]:
        if _PATH.fullmatch(written := (_HERE.sub("", word.removeprefix(_PROJECT) if own else word))):
            path = posixpath.normpath(posixpath.join(folder, written))
            if not path.startswith("..") and path not in {".", folder}:
                yield InstalledPath(path=path, folder=folders, line=call.line)


def not_there(found: Iterable[InstalledPath], text: str, repository: Repository) -> tuple[InstalledPath, ...]:
    """Return those that are not in the tree; none where the file, whose ``text`` is given, may make them itself.

    It may where it names a file twice. Nothing is known of what lies in a submodule.
    """
    modules = repository.once(_submodules)
    lacking = tuple(
        each
        for each in found
        if not (repository.may_have(each.path) or f"{each.path}/".startswith(modules))
        if each.folder or text.count(posixpath.basename(each.path)) == 1
    )
    return () if lacking and _writes(text) else lacking


def code_not_there(
    found: Mapping[str, int], text: str, folder: str, repository: Repository
) -> tuple[tuple[str, int], ...]:
    """Return the files of code that are compiled and not in the tree, each with its line; none that the file may make.

    ``found``: by their paths from the folder of the CMakeLists.txt, whose ``text`` is given.
    """
    modules = repository.once(_submodules)
    paths = {posixpath.normpath(posixpath.join(folder, name)): (name, line) for name, line in found.items()}
    absent = (
        (path, name, line)
        for path, (name, line) in paths.items()
        if not (path.startswith(("..", *modules)) or repository.may_have(path))
    )
    lacking = tuple(
        (path, line) for path, name, line in islice(absent, MAX_PATHS) if _only_compiled(posixpath.basename(name), text)
    )
    return () if lacking and _writes(text) else lacking


def _only_compiled(name: str, text: str) -> bool:
    """Tell whether all that a file of CMake does with another one is to compile it: else it may make it."""
    times = text.count(name)
    return times == 1 or times == _compiled(text).count(name)


@lru_cache(maxsize=1)  # a file is asked about once for each of its options
def _compiled(text: str) -> str:
    """Return what programs and libraries are compiled from, each on lines of its own."""
    return "\n".join(_COMPILES.findall(text))


@lru_cache(maxsize=1)
def _writes(text: str) -> bool:
    return bool(_WRITES.search(text))


def _submodules(repository: Repository) -> tuple[str, ...]:
    """Return the folders of submodules, each with a ``/`` behind it."""
    files = repository.named(git_modules.FILE)
    found = ((file, each.path) for file in files for each in git_modules.entries(repository.read(file)))
    return tuple(posixpath.normpath(posixpath.join(file.folder, path)) + "/" for file, path in found)


def _keyword(word: str) -> bool:
    """Tell whether a word is one of CMake's: ``DESTINATION``, ``FILES_MATCHING``; a file may be called ``LICENSE``."""
    return word in {
        *("DESTINATION", "TYPE", "FILES_MATCHING", "PATTERN", "REGEX", "COMPONENT", "PERMISSIONS", "CONFIGURATIONS"),
        *("RENAME", "USE_SOURCE_PERMISSIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "MESSAGE_NEVER"),
        *("EXCLUDE_FROM_ALL", "EXCLUDE", "USE_SCOPED_HEADER_INSTALL_DIR"),
    }
