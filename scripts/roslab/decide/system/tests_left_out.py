"""Tests that are left out because nothing brings what CMake requires for them alone."""

from __future__ import annotations

from collections.abc import Callable, Collection

from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.left_out import folders_of
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.required import own_names, provided_as
from roslab.decide.system.tests import BUILD_TESTING, left_to_a_switch
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def of_tests(evidence: Evidence, target: Target, packages: Packages, names: Collection[str]) -> dict[str, Dependency]:
    """Return the options that leave tests out, each with the first package that they require and nothing brings."""
    inside = own_names(evidence, packages)
    switches: dict[str, Dependency] = {}
    for asked, switch in left_to_a_switch(evidence):
        found = resolve(asked, target)
        built = found.recipe and plain(found.recipe) in names
        of_cmake = built or (found.known and not (found.apt or found.recipe))
        if asked.name not in inside and not of_cmake and not provided_as(asked.name, names):
            switches.setdefault(switch, asked)
    return switches


def of_package_tests(
    evidence: Evidence, target: Target, packages: Packages, names: Collection[str], may_hold: Callable[[str], bool]
) -> dict[str, Dependency]:
    """Return the option that leaves out the tests of packages, where these alone ask for a package that nobody has."""
    inside, folders = own_names(evidence, packages), folders_of(packages, [str(m.name) for m in packages.built])
    said = any(m.topic == "build_tool" and BUILD_TESTING in m.text for m in evidence.mentions)
    for asked, switch in () if said else left_to_a_switch(evidence):
        within = any(not folder or asked.file.startswith(f"{folder}/") for folder in folders)
        known = asked.name in inside or resolve(asked, target).known or provided_as(asked.name, names)
        if switch == BUILD_TESTING and within and not known and not may_hold(asked.name):
            return {switch: asked}
    return {}
