"""What a CMakeLists.txt calls although the CMake that it asks for may not have it yet."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from functools import cache

from roslab.evidence import git_modules
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call
from roslab.evidence.lex.lines import matching_lines
from roslab.evidence.native.cmake_needs import made_here
from roslab.evidence.native.imported_targets import of_others
from roslab.knowledge.cmake_since import since
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.version import Version

_DEFINED = pattern(r"^[ \t]*(?:function|macro|add_library)[ \t]*\([ \t\n]*([\w:.+-]+)", re.IGNORECASE | re.MULTILINE)
_VERSION = pattern(r"(\d+(?:\.\d+){1,3})(?:\.\.\.|$)")
_BY_CONFIG = pattern(r"\bfind_package[ \t]*\(\s*(\w+)\b[^()#]{0,200}\s(?:CONFIG|NO_MODULE)\b", re.IGNORECASE)
_DEFINING = ("function", "FUNCTION", "macro", "MACRO", "add_library", "ADD_LIBRARY")
_MODULE = ("include", "find_package")
_BEGINS = frozenset({*_MODULE, "list", "string", "file", "set"})
"""Calls whose first words tell what they do, or which module they are about."""
_CMAKE = "CMake"
MAX_SIZE = 256 * 1024
MAX_FILES = 400


@cache
def names() -> frozenset[str]:
    """Return the calls that are looked at."""
    return frozenset(since())


@cache
def of_included() -> frozenset[str]:
    """Return those that tell as much in a file that is included."""
    return frozenset(name for name, each in since().items() if not each[0].words)


def note(call: Call, path: str, into: dict[str, Dependency]) -> None:
    """Note what a call needs that the first releases of CMake do not have; one that may not be made needs nothing."""
    if call.name not in since() or call.conditions or call.in_function:
        return
    found = [each for each in since()[call.name] if _has(call, each.words)]
    best = max(found, key=lambda each: Version(each.release), default=None)
    if best is None or (call.name == "find_package" and "REQUIRED" not in call.words):
        return
    named = call.name in {*_MODULE, "target_link_libraries"}
    name = best.words[0] if named else " ".join((call.name, *best.words))
    into.setdefault(
        name,
        Dependency(
            namespace="cmake",
            name=name,
            strength="declared",
            file=path,
            line=call.line,
            role="build",
            version=best.release,
        ),
    )


def minimum(call: Call, path: str) -> Dependency | None:
    """Return the release that is required, of ``VERSION 3.15...3.28`` the first: the second is for policies."""
    version = next((m[1] for word in call.words if (m := _VERSION.match(word))), None)
    if version is None or call.conditions:
        return None
    return _required(call, path, version)


def raised(call: Call, path: str, into: dict[str, Dependency]) -> None:
    """Keep the highest release that a usual build is asked for, wherever ``cmake_minimum_required`` stands.

    A later one, below an option that is on, stops the older CMakes that the first one lets pass.
    """
    version = next((m[1] for word in call.words if (m := _VERSION.match(word))), None)
    if version is None or call.in_function or not made_here(call.conditions):
        return
    before = into.get(_CMAKE)
    if before is None or Version(version) > Version(before.version or "0"):
        into[_CMAKE] = _required(call, path, version)


def _required(call: Call, path: str, version: str) -> Dependency:
    return Dependency(
        namespace="cmake", name=_CMAKE, strength="declared", file=path, line=call.line, role="build", version=version
    )


def _has(call: Call, words: tuple[str, ...]) -> bool:
    """Tell whether words stand in a call, of a module or of a subcommand at its beginning."""
    if call.name in _BEGINS:
        return call.words[: len(words)] == words
    return not words or words[0] in call.words


def without_own(
    projects: Iterable[CMakeProject], repository: Repository, modules: frozenset[str]
) -> list[CMakeProject]:
    """Return the projects without what the tree itself has: a function of this name, a module (``FindNAME.cmake``).

    Nor what its find_package takes from the library's own configuration file, which needs no release of CMake.
    And without the imported targets that it makes, whose library a module of it finds, or that it brings itself: by
    FetchContent and its like, or as a submodule.
    """
    found = list(projects)
    if not any(project.newer or any(each.target for each in project.dependencies) for project in found):
        return found
    own = {
        *modules,
        *(file.name.removesuffix(".cmake") for file in repository.suffixed(".cmake")),
        *defined(repository),
    }
    itself = {name.lower() for project in found for name in project.brought}
    submodules = [each.path for each in git_modules.entries(repository.read(git_modules.FILE))]
    itself |= {path.rpartition("/")[2].lower() for path in (*repository.listing.empty, *submodules)}
    itself |= {"gtest"} if "googletest" in itself else set()
    brought = itself | set(_by_config(repository))
    return [
        replace(
            project,
            newer=tuple(each for each in project.newer if each.name not in own and not _of(each.name, brought)),
            dependencies=tuple(
                each for each in project.dependencies if of_others(each, own) and not _of(each.target, itself)
            ),
        )
        for project in found
    ]


def _of(target: str, libraries: Collection[str]) -> bool:
    """Tell whether an imported target (``yaml-cpp::yaml-cpp``) is of one of these libraries."""
    return "::" in target and target.partition("::")[0].lower() in libraries


def _by_config(repository: Repository) -> Iterator[str]:
    """Yield the packages, in lower case, that a file of the tree finds by their own configuration files alone.

    https://cmake.org/cmake/help/latest/command/find_package.html (CONFIG, NO_MODULE), 2026-11-27
    """
    for file in (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake"))[:MAX_FILES]:
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        yield from (match[1].lower() for match in _BY_CONFIG.finditer(text))


def defined(repository: Repository) -> set[str]:
    """Return the functions, macros and libraries that files of the tree define, functions in lower case."""
    files = (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake"))[:MAX_FILES]
    texts = (repository.read(file) for file in files if file.size <= MAX_SIZE)
    found = (match[1] for text in texts for match in matching_lines(_DEFINED, text, *_DEFINING))
    return {name if "::" in name else name.lower() for name in found}
