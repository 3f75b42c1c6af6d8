"""Repositories that a page or a script clones into the tree, where CMake then names a folder of theirs."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

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
_OF_TARGETS = frozenset(
    [
        "target_include_directories",
        "target_link_directories",
        "target_link_libraries",
        "add_library",
        "add_executable",
        "cuda_add_library",
        "cuda_add_executable",
    ]
)
_PATH = pattern(
    r"(?:\$\{(PROJECT|CMAKE|CMAKE_CURRENT)_SOURCE_DIR\}/)?((?:(?:\.\.?|[\w+-][\w.+-]*)/){0,11}(?:\.\.?/|[\w+-][\w.+-]*/?))$"
)


def read(repository: Repository, sources: Iterable[GitSource], projects: Iterable[CMakeProject]) -> Iterator[GitSource]:
    """Yield each such clone with the path in the tree that CMake means, once; the first file that names it counts.

    What the tree has a folder of the same path for is there, and submodules are none of them, nor is the repository.
    """
    sources = tuple(sources)
    modules = {git.name for git in sources if git.kind == "submodule"}
    near = [git for git in sources if git.kind == "clone" and git.file.count("/") <= DEEPEST]
    near = [git for git in near if git.name.lower() != repository.name.lower()]
    clones = {git.folder: git for git in reversed(near) if not places.vendored(git.file)}
    if not clones:
        return
    tops = frozenset(project.file.rpartition("/")[0] for project in projects if project.name)
    files = [file for file in repository.named("CMakeLists.txt") if not places.vendored(file.path)]
    files = nearest(files)[:MAX_FILES]
    for file in files:
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        named = [git for name, git in clones.items() if name in text]
        for path in _paths(text, file, tops) if named else ():
            for git in named:
                place = _up_to(git.folder, path)
                if git.folder in clones and place and place not in repository.folders and place not in modules:
                    yield replace(clones.pop(git.folder), name=place, kind="inside")


def _paths(text: str, file: File, tops: frozenset[str]) -> Iterator[str]:
    """Yield the paths below the root that calls name; a bare word is one only where a call takes folders alone."""
    for call in calls(text, _OF_FOLDERS | _OF_TARGETS):
        for word in _words(call):
            match = _PATH.match(word)
            if match and (match[1] or "/" in match[2] or call.name in _OF_FOLDERS):
                folder = _top(file.folder, tops) if match[1] in {"PROJECT", "CMAKE"} else file.folder
                path = posixpath.normpath(posixpath.join(folder, match[2]))
                if not path.startswith(".."):
                    yield path


def _words(call: Call) -> tuple[str, ...]:
    return call.words[:1] if call.name == "add_subdirectory" else call.words[call.name in _OF_TARGETS :]


def _top(folder: str, tops: frozenset[str]) -> str:
    """Return the folder of the project that a folder belongs to."""
    while folder and folder not in tops:
        folder = folder.rpartition("/")[0]
    return folder


def _up_to(name: str, path: str) -> str:
    """Return the part of a path that ends with the folder of that name, ``""`` for a path without one."""
    match = re.match(rf"((?:[^/]+/)*?{re.escape(name)})(?:/|$)", path)
    return match[1] if match else ""
