"""What CMake requires for the tests of a program alone: an option leaves them out, or what they need is installed."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.programs import top_of
from roslab.decide.system.added_projects import folder_of
from roslab.decide.system.switches import given, switch_of, switched_off, switched_on, waits
from roslab.decide.system.unreached import unreached
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence

BUILD_TESTING = "BUILD_TESTING"
"""CTest's own switch. https://cmake.org/cmake/help/latest/module/CTest.html"""


def left_to_a_switch(evidence: Evidence) -> Iterator[tuple[Dependency, str]]:
    """Yield what CMake requires for the tests, each with the option that leaves them out.

    What a page gives the option for is not left out.
    """
    options = given(evidence)
    for _, asked in _asked(evidence):
        named = BUILD_TESTING in (asked.condition or "")
        switch = BUILD_TESTING if named and f"-D{BUILD_TESTING}" not in options else switch_of(asked, options)
        if switch and not waits(asked, options) and (named or asked.strength == "declared"):
            yield asked, switch


def always_compiled(evidence: Evidence) -> Iterator[Dependency]:
    """Yield what CMake requires for tests that nothing leaves out, or that a page asks for."""
    options, top = given(evidence), top_of(evidence)
    for project, asked in _asked(evidence):
        # One that another project adds is compiled where that is, which is not sure beside package.xml files
        own = top is None or project.top == folder_of(top)
        reached = own or not (evidence.manifests or project.file in unreached(evidence))
        within = (project.added and reached) or "/" not in project.file
        unasked = asked.strength == "declared" and not asked.condition
        if within and (unasked or switched_on(asked, options)) and not switched_off(asked, options):
            yield asked


def always_of_packages(evidence: Evidence, folders: frozenset[str]) -> Iterator[Dependency]:
    """Yield what CMake requires for tests in the folders that packages of a workspace always add."""
    for project, asked in _asked(evidence):
        if project.always and project.added and asked.strength == "declared" and not asked.condition:
            folder = project.file.rpartition("/")[0]
            if any(not each or f"{folder}/".startswith(f"{each}/") for each in folders):
                yield asked


def _asked(evidence: Evidence) -> Iterator[tuple[CMakeProject, Dependency]]:
    for project in evidence.cmake:
        for asked in project.dependencies if not places.vendored(project.file) else ():
            if asked.namespace == "cmake" and asked.role == "test":
                yield project, asked
