"""The folders whose C++ is compiled as C++11, which the headers of newer libraries refuse."""

from __future__ import annotations

import re
from collections.abc import Mapping

from roslab.evidence import places
from roslab.evidence.lex.lines import matching_lines
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_FLAG = pattern(r"^[^#\n]*?-std=(?:c|gnu)\+\+(\d\w)\b", re.MULTILINE)
_VARIABLE = pattern(r"^[^#\n]*?(?:\bCMAKE_CXX_STANDARD[ \t]+|\bcxx_std_|\bCXX_STANDARD[ \t]+)(\d\w)\b", re.MULTILINE)
_ASKS = pattern(r"\bcheck_\w*compiler_flag\b", re.IGNORECASE)
_OLD = frozenset({"98", "03", "0x", "11"})


def read(repository: Repository, cmake: str) -> dict[str, bool]:
    """Return the folders whose CMakeLists.txt names a standard of C++, and whether all that it names are older than 14.

    ``cmake`` is what CMake calls the library: the targets of one that is found by it raise CMAKE_CXX_STANDARD, which no
    flag is raised by: https://cmake.org/cmake/help/latest/manual/cmake-compile-features.7.html, 2026-11-26.
    """
    found: dict[str, bool] = {}
    for file in repository.named("CMakeLists.txt"):
        if places.aside(file.path):
            continue
        text = repository.read(file)
        lines = ((text[match.start() : match.end()], match[1]) for match in matching_lines(_FLAG, text, "-std="))
        flags = {standard for line, standard in lines if not _ASKS.search(line)}
        named = {match[1] for match in matching_lines(_VARIABLE, text, "CXX_STANDARD", "cxx_std_")}
        if flags | named:
            raised = not flags and re.search(rf"\bfind_package\s*\(\s*{cmake}\b", text, re.IGNORECASE)
            found[file.folder] = flags | named <= _OLD and not raised
    return found


def is_old(path: str, standards: Mapping[str, bool], packages: frozenset[str]) -> bool:
    """Tell whether a file is compiled so: by the nearest folder above it that names a standard, up to its package."""
    folder = path.rpartition("/")[0]
    while folder not in standards:
        if not folder or folder in packages:
            return False
        folder = folder.rpartition("/")[0]
    return standards[folder]
