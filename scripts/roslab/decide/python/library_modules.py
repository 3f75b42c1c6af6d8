"""Modules that the source of a library holds, and that no index has: the library is built, and pip installs them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.library_modules import LibraryModules, library_modules
from roslab.values.dataclass import replace
from roslab.values.requirement_line import stated

OF_MODULE = "module"
"""Role of a library that is asked for by a module of its."""


def with_library_modules(evidence: Evidence) -> Evidence:
    """Return the evidence with each such library and package, for the imports and lists that ask for the module.

    Not where the tree has the library's source as a submodule: it is built from that.
    """
    for row in library_modules():
        place = next(_places(row, evidence), None)
        inside = (git.name.rpartition("/")[2] for git in evidence.sources if git.kind == "submodule")
        if place is None or row.library in inside:
            continue
        file, line = place
        asked = Dependency(namespace="cmake", name=row.library, strength="used", file=file, line=line, role=OF_MODULE)
        code = (each for each in evidence.code if each.namespace != "import" or each.name not in row.modules)
        package = stated(row.installs, "prose", file, line)
        evidence = replace(evidence, code=(*code, asked), prose_pip=(*evidence.prose_pip, package))
    return evidence


def variables_of(libraries: Iterable[str]) -> Iterator[tuple[str, str, str]]:
    """Yield the variables by which the built ``libraries`` are found, each with its value and why."""
    built = set(libraries)
    for row in library_modules():
        for variable in row.variables if row.library in built else ():
            name, _, value = variable.partition("=")
            yield name, value, f"programs that use {row.library} look there for it"


def _places(row: LibraryModules, evidence: Evidence) -> Iterator[tuple[str, int]]:
    for use in evidence.code:
        counts = use.strength == "used" and not places.aside(use.file)
        if use.namespace == "import" and use.name in row.modules and counts:
            yield use.file, use.line
    listed = (asked for file in evidence.requirements if file.purpose == "run" for asked in file.requirements)
    projects = (asked for project in evidence.python for asked in project.requirements)
    for asked in (*listed, *projects):
        if asked.key == row.pip and not asked.url and not places.vendored(asked.file):
            yield asked.file, asked.line
