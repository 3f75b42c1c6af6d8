"""What the compiler must be told to find the headers of packages, by the paths that the code writes."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import fits
from roslab.knowledge.header_folders import HeaderFolder, header_folders
from roslab.knowledge.standard_headers import missed_headers

_FOLDERS, _FLAGS = "CPATH", "CXXFLAGS"
"""https://gcc.gnu.org/onlinedocs/gcc/Environment-Variables.html, and
https://cmake.org/cmake/help/latest/envvar/CXXFLAGS.html, read 2026-11-26."""


def compiler_variables(evidence: Evidence, ubuntu: str | None) -> Iterator[tuple[str, str, str, Dependency]]:
    """Yield variables with their values, why each is set, and the first include that needs it.

    A folder is not told again where CMake finds the package that tells it. Each source is compiled with a header of the
    compiler's that one lacks, which no other minds, unless the GCC of the ``ubuntu`` brings it along.
    """
    found = {
        d.name for project in evidence.cmake for d in project.dependencies if d.namespace in {"cmake", "pkg-config"}
    }
    folders: dict[str, Dependency] = {}
    flags: dict[str, Dependency] = {}
    for row in header_folders():
        asked = _included(row, evidence)
        if asked and row.folder and not row.found_by & found:
            folders.setdefault(row.folder, asked)
        if asked and row.flags:
            flags.setdefault(row.flags, asked)
    for asked in _lacking(evidence, ubuntu):
        flags.setdefault(f"-include {asked.name}", asked)
    if folders:
        first = next(iter(folders.values()))
        yield (
            _FOLDERS,
            ":".join(folders),
            f"the package of {first.name} has it in a folder where no compiler looks",
            first,
        )
    if flags:
        first = next(iter(flags.values()))
        used = f"{first.role} is used without <{first.name}>" if first.namespace == "unincluded" else ""
        yield _FLAGS, " ".join(flags), used or f"{first.name} does not compile without it", first


def _included(row: HeaderFolder, evidence: Evidence) -> Dependency | None:
    for each in evidence.code:
        wanted = any(each.name == name or (name.endswith("/") and each.name.startswith(name)) for name in row.headers)
        if each.namespace == "include" and wanted and not places.aside(each.file):
            return each
    return None


def _lacking(evidence: Evidence, ubuntu: str | None) -> Iterator[Dependency]:
    """Yield the headers of the compiler that some source uses and lacks with this Ubuntu's GCC."""
    since = {row.header: row.since for row in missed_headers()}
    for each in evidence.code:
        if each.namespace == "unincluded":
            first = since.get(each.name)
            if first is None or (ubuntu and fits("GCC", ubuntu, at_least=first, below=None)):
                yield each
