"""Files of libraries below the source that a target is always linked with, and that nothing in the tree is or makes."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence.lex.cmake import Call
from roslab.evidence.native.cmake_needs import MAX_LINKED
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

_LINKS = frozenset({"target_link_libraries", "link_libraries"})
_FILE = pattern(r"\$\{(PROJECT|CMAKE_CURRENT)_SOURCE_DIR\}/([\w.+/-]{1,200}/lib[\w+-]{1,60}\.(?:so|a))")
_MAKES = pattern(
    r"\b(?:execute_process|exec_program|externalproject_\w+|fetchcontent_\w+|cpm\w+|add_custom_\w+|file\s*\(\s*download|output_name)\b",
    re.IGNORECASE,
)
"""Calls that may make a file while CMake configures or builds, and what has it called unlike its target."""
_PAGES = (".md", ".rst", ".sh", ".bash")
MAX_PAGES = 40
"""Most pages and scripts that are searched, those nearest to the root first."""
_OF_BUILDS = ("CMakeLists.txt", "Makefile", "makefile", "configure", "meson.build", "build.sh", "setup.py")


def named(call: Call, folder: str, *, own: bool) -> Iterator[tuple[str, int]]:
    """Yield such files of a call in a folder's CMakeLists.txt, each with its line; ``own``: it has a ``project()``."""
    if call.name not in _LINKS or call.conditions or call.in_function:
        return
    for word in call.words[:MAX_LINKED]:
        match = _FILE.fullmatch(word)
        if match and (own or match[1] != "PROJECT"):
            yield posixpath.normpath(posixpath.join(folder, match[2])), call.line


def lost(files: dict[str, int], folder: str, text: str, repository: Repository) -> tuple[tuple[str, int], ...]:
    """Return those that the tree does not have, none where the file calls what may make them.

    ``files`` are those that :func:`named` yields for ``folder``, each with its line. What lies in a folder with a file
    of some builder, beside ``folder`` or below it, may be compiled there, and a page or a script that names the library
    or its folder may tell how it is made.
    """
    if not files or _MAKES.search(text):
        return ()
    found = (
        (path, line)
        for path, line in files.items()
        if not path.startswith("..")
        and not repository.may_have(path)
        and not repository.named(posixpath.basename(path))
        if not any(repository.has(f"{each}/{name}") for each in _beside(path, folder) for name in _OF_BUILDS)
    )
    return tuple(each for each in found if not _told(each[0], repository))


def _told(path: str, repository: Repository) -> bool:
    """Tell whether a page or a script names a library, or goes to the folder in which it is made."""
    folder = re.escape(posixpath.dirname(path).removesuffix("/lib") or posixpath.basename(path))
    names = re.compile(rf"\b{re.escape(posixpath.basename(path))}|\bcd\s+\S{{0,200}}?(?<![\w.-]){folder}(?![\w.-])")
    pages = nearest(repository.suffixed(*_PAGES))[:MAX_PAGES]
    return any(names.search(repository.read(file)) for file in pages)


def _beside(path: str, folder: str) -> Iterator[str]:
    """Yield the folders that hold a path, from the inmost on, but for ``folder`` and those that hold that."""
    while path := posixpath.dirname(path):
        if not f"{folder}/".startswith(f"{path}/"):
            yield path
