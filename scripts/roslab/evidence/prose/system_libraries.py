"""Libraries that the tree holds compiled and that a script or a page copies into the system, where CMake links them.

``sudo cp lib/libacme.so /usr/local/lib``, and the others that the same file copies there, which that one may need.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator
from fnmatch import fnmatchcase

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import logical_lines
from roslab.evidence.native.x86_binaries import is_x86
from roslab.evidence.prose.pages import pages
from roslab.evidence.x86_only import X86Only
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_FILES = 100
"""Most pages and scripts, and most build files, that are opened, those nearest to the root first."""
MOST = 40
"""Most libraries that are copied."""
LIBRARY = pattern(r"lib([\w+-]+?)\.(?:so(?:\.\d+)*|a)")
_COPIES = pattern(
    r"(?<![\w./-])(?:cp|install)[ \t]+([^\n;&|`]{1,600}?)[ \t]+[\"']?((?:/usr)?(?:/local)?/lib(?:/[\w.+-]+)*)/?[\"']?"
    r"(?=[\s`;&|)]|$)"
)
_HERE = pattern(r"^(?:\$\(pwd\)|`pwd`|\$\{?PWD\}?|\.)/")
_BUILDS = ("CMakeLists.txt", "Makefile", "makefile")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield for each folder of the system (``value``) the libraries (``files``) that a file copies there."""
    yield from repository.once(_read)


def of_x86(repository: Repository) -> Iterator[X86Only]:
    """Yield the first such library, unless one for another processor is copied with it.

    Of archives, which are linked only where one is needed, none counts beside shared libraries.
    """
    for said in repository.once(_read):
        shared = [path for path in said.files if ".so" in path]
        if all(is_x86(path, repository) for path in shared or said.files):
            yield X86Only(said.files[0], "binary", said.file, said.line)
            return


def _read(repository: Repository) -> tuple[Mention, ...]:
    there = [
        file.path
        for file in repository.files
        if file.name.startswith("lib") and LIBRARY.fullmatch(file.name) and not places.vendored(file.path)
    ]
    if not there:
        return ()
    scripts = nearest(repository.suffixed(*SHELL_SCRIPTS))[:MAX_FILES]
    for file in (*scripts, *pages(repository)):
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        if "/lib" in text and (found := tuple(_copied(file, text, there))):
            names = {match[1] for _, paths, _ in found for path in paths if (match := _library(path))}
            if _linked(names, repository):
                return tuple(_merged(file, found))
    return ()


def _copied(file: File, text: str, there: list[str]) -> Iterator[tuple[str, tuple[str, ...], int]]:
    """Yield each folder of the system, the libraries of the tree that are copied to it, and the line."""
    for start, line in logical_lines(text):
        for match in _COPIES.finditer(line.replace("\n", " ")):
            words = (word.strip("\"'") for word in match[1].split() if not word.startswith("-"))
            paths = [path for word in words for path in _of_tree(_HERE.sub("", word), file, there)]
            if paths:
                yield match[2], tuple(dict.fromkeys(paths)), start


def _of_tree(written: str, file: File, there: list[str]) -> list[str]:
    """Return the libraries that a word of a call names: from the root, from the file's folder, else by its end."""
    path = posixpath.normpath(written)
    if "$" in path or path.startswith(("..", "/")):
        return []
    for whole in (path, posixpath.join(file.folder, path)):
        if found := [each for each in there if each.count("/") == whole.count("/") and fnmatchcase(each, whole)]:
            return found
    ends = [each for each in there if fnmatchcase(each, f"*/{path}")]
    return ends if len({posixpath.dirname(each) for each in ends}) == 1 else []


def _merged(file: File, found: Iterable[tuple[str, tuple[str, ...], int]]) -> Iterator[Mention]:
    folders: dict[str, list[str]] = {}
    lines: dict[str, int] = {}
    for folder, paths, line in found:
        folders.setdefault(folder, []).extend(paths)
        lines.setdefault(folder, line)
    for folder, all_paths in folders.items():
        kept = tuple(dict.fromkeys(all_paths))[:MOST]
        yield Mention(
            topic="system_library",
            value=folder,
            source="readme",
            file=file.path,
            line=lines[folder],
            text=f"cp {kept[0]} {folder}"[:200],
            files=kept,
        )


def _linked(names: set[str], repository: Repository) -> bool:
    """Tell whether a build file of the tree names one of these libraries."""
    named = re.compile(rf"(?<![\w.-])(?:lib|-l)?(?:{'|'.join(sorted(map(re.escape, names)))})(?![\w-])")
    files = (file for name in _BUILDS for file in repository.named(name) if not places.vendored(file.path))
    return any(file.size <= MAX_SIZE and named.search(repository.read(file)) for file in nearest(files)[:MAX_FILES])


def _library(path: str) -> re.Match[str] | None:
    return LIBRARY.fullmatch(posixpath.basename(path))
