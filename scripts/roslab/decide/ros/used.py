"""The names that are asked for, and which of them the build uses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.ros.included import imported, included
from roslab.decide.ros.keys import declared_keys
from roslab.decide.ros.own_targets import own_targets
from roslab.decide.ros.pip_keys import brought_by_pip
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.bare_links import as_packages
from roslab.decide.system.names import Target
from roslab.decide.system.needs import code_needs, started
from roslab.decide.system.switches import given, waits
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released, rosdep_keys
from roslab.values.requirement import Requirement


def asked(
    evidence: Evidence, packages: Packages, target: Target, kind: Kind, installed: Iterable[Requirement] = ()
) -> tuple[Dependency, ...]:
    """Return what package.xml files, build files, started programs, messages of the code and linked names ask for.

    Without the unknown keys that what pip installs brings (``installed``).
    """
    keys, by_pip = declared_keys(packages, target, kind), {each.key for each in installed}
    known = (released(target.ros_distro or ""), rosdep_keys())
    keys = tuple(k for k in keys if any(k.name in each for each in known) or not brought_by_pip(k, by_pip, evidence))
    ours = own_targets(keys, evidence)
    return (
        *(key for key in keys if key.name not in ours),
        *code_needs(evidence, packages),
        *started(evidence, kind),
        *included(evidence, packages),
        *imported(evidence, packages),
        *as_packages(evidence, packages, kind),
    )


def used_by_build(evidence: Evidence, needed: Iterable[Dependency]) -> Iterator[Dependency]:
    """Yield the names that the build uses: a package.xml may name what its CMakeLists.txt, which has a list, does not.

    catkin_simple looks for all that the package.xml names, and what a page links to is meant in earnest. Nothing is
    used that waits for an option that is off.
    """
    needed = tuple(needed)
    links = {plain(git.name) for git in evidence.sources if git.kind == "link" and not places.vendored(git.file)}
    named = {dependency.name for dependency in needed if dependency.namespace != "rosdep"}
    listing = {
        project.file.rpartition("/")[0]
        for project in evidence.cmake
        if any(d.namespace == "ros" for d in project.dependencies)
        and not any(d.name == "catkin_simple" for d in project.dependencies)
    }
    options = given(evidence)
    for dependency in needed:
        if waits(dependency, options):
            continue
        said = dependency.name in named or plain(dependency.name) in links
        if said or dependency.file.rpartition("/")[0] not in listing:
            yield dependency


def spoken_of(evidence: Evidence, needed: Iterable[Dependency]) -> Iterator[Dependency]:
    """Yield the keys of package.xml files that the code may name where CMake does not: ``package://arm_description/…``.

    Not one that nothing else of its package names, nor one that waits for an option that is off.
    """
    left_over = {said.value for said in evidence.mentions if said.topic == "only_in_manifest"}
    options = given(evidence)
    for key in needed:
        if key.namespace == "rosdep" and key.name not in left_over and not waits(key, options):
            yield key
