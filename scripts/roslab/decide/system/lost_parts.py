"""What a build looks for or links, and nothing brings: libraries, programs, modules of CMake, bare names."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from roslab.decide.decision import Warning_
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.bare_links import without_linked
from roslab.decide.system.built import Built
from roslab.decide.system.lost_libraries import lost_libraries
from roslab.decide.system.without_modules import without_modules
from roslab.decide.system.without_programs import without_programs
from roslab.evidence.facts import Evidence


def lost_parts(
    evidence: Evidence,
    packages: Packages,
    of_build: Built,
    may_hold: Callable[[str], bool],
    tried: Mapping[str, str],
) -> Iterator[tuple[str, Warning_]]:
    """Yield the libraries and programs that CMake looks for or links and nothing brings, each with its file."""
    yield from lost_libraries(evidence, packages, of_build.build_tool)
    yield from without_programs(evidence, packages, of_build)
    yield from without_modules(evidence, packages, of_build, may_hold)
    yield from without_linked(evidence, packages, of_build, may_hold, tried)
