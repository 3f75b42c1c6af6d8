"""What build files clone and call while they configure or make: CMake's, its templates, Makefiles of rosbuild."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import calls
from roslab.evidence.lex.lines import first_line, matching_lines
from roslab.evidence.native import called_programs
from roslab.evidence.native.cmake_needs import of_no_build
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 300
"""Most files of each kind, those nearest to the root first."""
_CLONES = pattern(r"[^#\n]*\b(?:GIT_REPOSITORY|GITHUB_REPOSITORY|CPMAddPackage|git\s+clone)\b")
_TEMPLATE = pattern(r"(?:CMakeLists(?:\.\w+)*|\.cmake)\.in$")
"""A recipe that CMake fills in and another call of it builds: https://google.github.io/googletest/quickstart-cmake.html"""
_DOWNLOADS = frozenset({"externalproject_add", "fetchcontent_declare", "fetchcontent_populate", "file"})
_INCLUDED = pattern(r"include\s[^#\n]{0,80}\bmk\)?/(\w+)\.mk\b")
_UNSAFE = pattern(r"[^#\n]*?\bgit://([\w.-]+)/")


@dataclass(frozen=True, slots=True)
class Fetching:
    """What a build needs to clone, and the programs that it calls."""

    programs: tuple[Dependency, ...] = ()
    hosts: tuple[str, ...] = ()
    """The hosts that are named by ``git://``."""


def read(repository: Repository) -> Fetching:
    """Return the programs that clone or are called, each where it is first, and the hosts not of copied code."""
    found: dict[str, Dependency] = {}
    hosts: dict[str, None] = {}
    of_cmake = _cmake(repository)
    for file, makefile in (*((file, False) for file in of_cmake), *_makefiles(repository)):
        text = repository.read(file)
        for name, line in _called(text, makefile=makefile):
            asked = Dependency(namespace="apt", name=name, strength="used", file=file.path, line=line, role="fetch")
            found.setdefault(name, asked)
        if not places.vendored(file.path):
            hosts |= dict.fromkeys(match[1] for match in matching_lines(_UNSAFE, text, "git://"))
    for asked in called_programs.read(repository, of_cmake):
        found.setdefault(asked.name, asked)
    return Fetching(tuple(found.values()), tuple(hosts))


def _cmake(repository: Repository) -> list[File]:
    files = [*repository.suffixed(".cmake"), *repository.named("CMakeLists.txt")]
    files += [file for file in repository.suffixed(".in") if _TEMPLATE.search(file.name)]
    return [file for file in _nearest(files) if "/CMakeFiles/" not in file.path]


def _makefiles(repository: Repository) -> Iterator[tuple[File, bool]]:
    """Yield the Makefiles of packages of rosbuild."""
    packages = {file.folder for file in repository.named("manifest.xml")}
    return ((file, True) for file in _nearest(repository.named("Makefile")) if file.folder in packages)


def _nearest(files: list[File] | tuple[File, ...]) -> list[File]:
    kept = (file for file in files if file.size <= MAX_SIZE)
    return nearest(kept)[:MAX_FILES]


def _called(text: str, *, makefile: bool) -> Iterator[tuple[str, int]]:
    """Yield the packages of what a file calls to fetch, each with its line."""
    if makefile:
        for match in matching_lines(_INCLUDED, text, "include"):
            from roslab.knowledge.rosbuild_makefiles import program_of  # noqa: PLC0415 - few trees have a Makefile of rosbuild

            if name := program_of(match[1]):
                line = text.count("\n", 0, match.start()) + 1
                yield name, line
                yield "ca-certificates", line
        return
    if cloned := first_line(_CLONES, text, "_REPOSITORY", "CPMAddPackage", "git"):
        line = text.count("\n", 0, cloned.start()) + 1
        yield "ca-certificates", line
        yield "git", line
    elif line := _downloads(text):
        yield "ca-certificates", line


def _downloads(text: str) -> int:
    """Return the line of the first call that downloads a file by ``https://``, 0 for none: CMake asks for certificates.

    https://cmake.org/cmake/help/latest/command/file.html#download and
    https://cmake.org/cmake/help/latest/module/ExternalProject.html, 2026-11-27.
    """
    if "https://" not in text or not any(key in text for key in ("URL", "DOWNLOAD")):
        return 0
    for call in calls(text, _DOWNLOADS):
        if call.name == "file":
            given = call.words[1:2] if call.words[:1] == ("DOWNLOAD",) else ()
        else:
            given = tuple(after for key, after in pairwise(call.words) if key == "URL")
        if any(word.startswith("https://") for word in given) and not any(map(of_no_build, call.conditions)):
            return call.line
    return 0
