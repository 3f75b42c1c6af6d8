"""Code that nothing compiles: the files of copied libraries, and sources among headers, that nothing else includes."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable

from roslab.evidence.copied_libraries import folders_of_copies, in_copy
from roslab.evidence.lex.includes import includes
from roslab.evidence.native.unlisted import Unlisted
from roslab.repository.checkout import File, Repository

MAX_READ = 64 * 1024
_SOURCES = (".cpp", ".cc", ".cxx", ".c", ".cu")


def without_unreached(repository: Repository, files: Iterable[File]) -> list[File]:
    """Return code without the files of copied libraries that nothing else includes, in turn.

    So it is with a source below a folder of headers (``include/…/viewer.cpp``) that no list of CMake names: headers
    include it, or nothing compiles it.
    """
    files = list(files)
    folders = folders_of_copies(repository)
    unlisted = Unlisted(repository)
    apart = {file.path for file in files if in_copy(file.path, folders) or _among_headers(file.path, unlisted)}
    if not apart:
        return files
    by_name: dict[str, list[str]] = {}
    for path in apart:
        by_name.setdefault(path.rpartition("/")[2], []).append(path)
    reached: set[str] = set()
    asked: set[tuple[str, str]] = set()
    """Includes by the folder that has them: most are in many of its files."""
    waiting = [file.path for file in files if file.path not in apart]
    while waiting:
        path = waiting.pop()
        folder = path.rpartition("/")[0]
        new = {(folder, match[1]) for match in includes(repository.read(path, limit=MAX_READ))} - asked
        asked |= new
        for _, name in new:
            candidates = by_name.get(name.rpartition("/")[2])
            for found in _meant(name, folder, candidates, folders) if candidates else ():
                if found not in reached:
                    reached.add(found)
                    waiting.append(found)
    return [file for file in files if file.path not in apart or file.path in reached]


def _among_headers(path: str, unlisted: Unlisted) -> bool:
    return path.endswith(_SOURCES) and "include" in path.split("/")[:-1] and unlisted.has(path)


def _meant(name: str, folder: str, candidates: Collection[str], folders: Collection[str]) -> list[str]:
    """Return the files that an include may mean: one beside the file alone, else those whose paths end so.

    Compilers look into the folder around a library, not into those inside it.
    """
    beside = posixpath.normpath(posixpath.join(folder, name))
    if beside in candidates:
        return [beside]
    name = posixpath.normpath(name)
    ends = [path for path in candidates if f"/{path}".endswith(f"/{name}")]
    return [path for path in ends if not in_copy(path.removesuffix(name), folders)]
