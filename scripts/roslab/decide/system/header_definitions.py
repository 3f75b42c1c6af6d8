"""Options for a compiler with which the headers of a library are enough, where CMake links none of it."""

from __future__ import annotations

from roslab.config.model import BuildTool, Config
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.header_definitions import header_definitions

_NO_CMAKE: frozenset[BuildTool] = frozenset({"pip", "conda", "none"})
_FLAGS = "CXXFLAGS"
"""The variable that CMake takes where no option has the flags."""


def header_definitions_of(evidence: Evidence, config: Config, build_tool: BuildTool) -> tuple[str, ...]:
    """Return CMake's option that defines what headers need which the code includes, while no CMake file links them.

    Not where roslab.yaml has flags under ``env``, which the option would replace.
    """
    if config.compatible or build_tool in _NO_CMAKE or _FLAGS in dict(config.env):
        return ()
    found = {
        name.lower()
        for project in evidence.cmake
        for name in (*(each.name for each in project.dependencies), *project.made, *project.brought)
    }
    included = [d.name for d in evidence.code if d.namespace == "include" and not places.vendored(d.file)]
    definitions = dict.fromkeys(
        row.definition
        for row in header_definitions()
        if found.isdisjoint(row.found_as) and any(name.startswith(row.include) for name in included)
    )
    flags = " ".join(f"-D{each}" for each in definitions)
    return (f"-DCMAKE_CXX_FLAGS={flags}",) if flags else ()
