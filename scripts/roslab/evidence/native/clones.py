"""Repositories that a page or a script clones into the tree, where CMake then names a folder of theirs."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import GitSource
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

DEEPEST = 1
"""A page or a script below is about a part."""
MAX_FILES = 300
"""Most CMake files that are searched, those nearest to the root first."""
MAX_SIZE = 256 * 1024
_OF_FOLDERS = frozenset({"add_subdirectory", "include_directories", "link_directories"})
_OF_FILES = frozenset({"include", "link_libraries"})
_OF_TARGETS = frozenset(
    [
        "target_include_directories",
        "target_link_directories",
        "target_link_libraries",
        "target_sources",
        "add_library",
        "add_executable",
        "cuda_add_library",
        "cuda_add_executable",
        "file",
    ]
)
_FIRST = frozenset({"add_subdirectory", "include"})
"""Calls whose first word alone is a path."""
_PATH = pattern(
    r"(?:(?:\$\{(?:CMAKE_CURRENT_(?:SOURCE|LIST)_DIR|([\w-]{1,60})_SOURCE_DIR)\}|(\$ENV\{HOME\}|~))(/))?"
    r"((?:(?:\.\.?|[\w+-][\w.+-]*)/){0,11}(?:\.\.?/|[\w+-][\w.+-]*/?))$"
)
_BESIDE = pattern(r"\.\./(?!\.\.(?:/|$))")


def read(repository: Repository, sources: Iterable[GitSource], projects: Iterable[CMakeProject]) -> Iterator[GitSource]:
    """Yield each such clone with the path in the tree that CMake means, once; the first file that names it counts.

    One beside the tree, or in the home folder, in which an image has a tree that is no workspace, is ``../NAME``.
    What the tree has a folder of the same path for is there, and submodules are none of them, nor is the repository.
    """
    sources = tuple(sources)
    modules = {git.name for git in sources if git.kind == "submodule"}
    near = [git for git in sources if git.kind == "clone" and git.file.count("/") <= DEEPEST]
    near = [git for git in near if git.name.lower() != repository.name.lower()]
    clones = {git.folder: git for git in reversed(near) if not places.vendored(git.file)}
    if not clones:
        return
    tops = {project.file.rpartition("/")[0]: project.name for project in projects if project.name}
    files = [file for file in repository.named("CMakeLists.txt") if not places.vendored(file.path)]
    files = nearest(files)[:MAX_FILES]
    of_ros = bool(repository.named("package.xml", "manifest.xml"))
    for file in files:
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        named = [git for name, git in clones.items() if name in text]
        for path in _paths(text, file, tops) if named else ():
            if path.startswith("..") and (of_ros or not _BESIDE.match(path)):
                continue
            for git in named:
                place = _up_to(git.folder, path)
                if git.folder in clones and place and place not in repository.folders and place not in modules:
                    yield replace(clones.pop(git.folder), name=place, kind="inside")


def _paths(text: str, file: File, tops: Mapping[str, str]) -> Iterator[str]:
    """Yield the paths from the root that calls name; a bare word is one only where a call takes folders alone."""
    for call in calls(text, _OF_FOLDERS | _OF_FILES | _OF_TARGETS):
        for word in _words(call):
            match = _PATH.match(word)
            if match and (match[3] or "/" in match[4] or call.name in _OF_FOLDERS):
                folder = file.folder if match[1] is None else _top(match[1], file.folder, tops)
                folder = ".." if match[2] else folder
                if folder is not None:
                    yield posixpath.normpath(posixpath.join(folder, match[4]))


def _words(call: Call) -> tuple[str, ...]:
    """Return the words of a call that may be paths: of ``file(GLOB VARIABLE …)``, what is before the first ``*``."""
    if call.name == "file":
        globs = call.words[2:] if call.words[0:1] in {("GLOB",), ("GLOB_RECURSE",)} else ()
        return tuple(word.partition("*")[0] for word in globs)
    return call.words[:1] if call.name in _FIRST else call.words[call.name in _OF_TARGETS :]


def _top(named: str, folder: str, tops: Mapping[str, str]) -> str | None:
    """Return the folder of the project that a folder belongs to, or of the only one of that name; else ``None``."""
    if named not in {"PROJECT", "CMAKE"}:
        found = [place for place, name in tops.items() if name == named]
        return found[0] if len(found) == 1 else None
    while folder and folder not in tops:
        folder = folder.rpartition("/")[0]
    return folder


def _up_to(name: str, path: str) -> str:
    """Return the part of a path that ends with the folder of that name, ``""`` for a path without one."""
    match = re.match(rf"((?:[^/]+/)*?{re.escape(name)})(?:/|$)", path)
    return match[1] if match else ""
