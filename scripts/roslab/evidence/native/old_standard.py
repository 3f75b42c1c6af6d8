"""The folders whose C++ is compiled as C++11, which the headers of newer libraries refuse."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping

from roslab.evidence import places
from roslab.evidence.lex.cmake import FROM_HERE, calls
from roslab.evidence.lex.lines import matching_lines
from roslab.evidence.native import cmake_needs
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_FLAG = pattern(r"^[^#\n]*?-std=(?:c|gnu)\+\+(\d\w)\b", re.MULTILINE)
_VARIABLE = pattern(r"^[^#\n]*?(?:\bCMAKE_CXX_STANDARD[ \t]+|\bcxx_std_|\bCXX_STANDARD[ \t]+)(\d\w)\b", re.MULTILINE)
_ASKS = pattern(r"\bcheck_\w*compiler_flag\b", re.IGNORECASE)
_OLD = frozenset({"98", "03", "0x", "11"})
_ADDING = frozenset({"add_subdirectory", "subdirs", "include"})


def read(repository: Repository, cmake: str) -> dict[str, bool]:
    """Return the folders whose CMakeLists.txt names a standard of C++, and whether all that it names are older than 14.

    ``cmake`` is what CMake calls the library: the targets of one that is found by it raise CMAKE_CXX_STANDARD, which no
    flag is raised by: https://cmake.org/cmake/help/latest/manual/cmake-compile-features.7.html, 2026-11-26.
    A file inside a package whose own CMake does not come to it says nothing of the package's code.
    """
    found: dict[str, bool] = {}
    packages = frozenset(file.folder for file in repository.named("package.xml"))
    for file in repository.named("CMakeLists.txt"):
        if places.aside(file.path):
            continue
        text = repository.read(file)
        lines = ((text[match.start() : match.end()], match[1]) for match in matching_lines(_FLAG, text, "-std="))
        flags = {standard for line, standard in lines if not _ASKS.search(line)}
        named = {match[1] for match in matching_lines(_VARIABLE, text, "CXX_STANDARD", "cxx_std_")}
        if flags | named:
            raised = not flags and re.search(rf"\bfind_package\s*\(\s*{cmake}\b", text, re.IGNORECASE)
            old = flags | named <= _OLD and not raised
            if not old or _comes_to(repository, file.folder, packages):
                found[file.folder] = old
    return found


def _comes_to(repository: Repository, folder: str, packages: frozenset[str]) -> bool:
    """Tell whether the CMake of the package around a folder adds it, or may: its calls name another by a variable."""
    package = places.innermost(folder, packages)
    if package is None or package == folder or not repository.has(posixpath.join(package, "CMakeLists.txt")):
        return True
    waiting, read_ = [package], set[str]()
    while waiting:
        if (at := waiting.pop()) == folder:
            return True
        if at in read_:
            continue
        read_.add(at)
        for call in calls(repository.read(posixpath.join(at, "CMakeLists.txt")), _ADDING):
            added = [FROM_HERE.sub("", each) for each in cmake_needs.folders(call)]
            if any("$" in each for each in added):
                return True
            waiting += [posixpath.normpath(posixpath.join(at, each)) for each in added]
    return False


def is_old(path: str, standards: Mapping[str, bool], packages: frozenset[str]) -> bool:
    """Tell whether a file is compiled so: by the nearest folder above it that names a standard, up to its package."""
    folder = path.rpartition("/")[0]
    while folder not in standards:
        if not folder or folder in packages:
            return False
        folder = folder.rpartition("/")[0]
    return standards[folder]
