"""Libraries that nothing known brings, and the repositories of the same owner in which the build looks for them.

Planning asks no host: a repository that is not there, or does not compile, is told while the image is built.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Config, Kind, Source
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.sought import MOST
from roslab.decide.ros.sought_addresses import public_owner
from roslab.decide.ros.source_names import address, plain, wraps
from roslab.decide.ros.weights import Weight
from roslab.decide.ros.with_recipes import with_recipes
from roslab.decide.ros.workspace import Packages, types
from roslab.decide.system.guards import required_by_tool
from roslab.decide.system.missing import provided
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.no_config import without_config
from roslab.decide.system.packages import SystemPackages
from roslab.decide.system.required import of_program, provided_as
from roslab.decide.system.switches import given, switch_of
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.libraries import library
from roslab.knowledge.released import ever_released, rosdep_keys
from roslab.values.dataclass import replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

_NAME = pattern(r"[A-Za-z][A-Za-z0-9]*(?:[_-][A-Za-z0-9]+)*")
"""A name that a repository may have, and no part of a library: ``DART utils`` is one."""
_SHORTEST = 3
"""Fewest letters of a name that is looked for."""


def with_tried(
    choice: Choice[Sources],
    libraries: Iterable[tuple[Source, Dependency]],
    config: Config,
    evidence: Evidence,
    kind: Kind,
    *,
    target: Target,
    packages: Packages,
    system: SystemPackages,
) -> Choice[Sources]:
    """Return the sources with the libraries that are built before them, and those that the build looks for.

    Of plain C++ that is what its CMake requires and what its package.xml, of plain CMake, names, where nothing known
    brings it: a repository of that name, of the same owner, as it was on the day of the last commit. It stops nothing.
    """
    found = with_recipes(choice, libraries, config, evidence, ros=bool(target.ros_distro))
    owner = public_owner(evidence)
    if kind != "cpp" or config.compatible or not owner:
        return found
    date = dated(evidence)
    taken = {address(source.repo or "") for source in found.answer.everything} | {address(evidence.origin)}
    sought: list[Source] = []
    reasons = []
    for name, asked in _lacking(evidence, found.answer, packages, target, system).items():
        repo = f"{owner}/{name}"
        if address(repo) in taken or len(sought) == MOST:
            continue
        sought.append(
            Source(
                name=name,
                repo=f"{repo}.git",
                build="cmake",
                before=date.value if date else "",
                depends=tuple(each for each in (*system.apt, *system.brought) if each.endswith("-dev")),
                unread=True,
                unasked=True,
                holding=(name,),
                place=Place(file=asked.file, line=asked.line),
            )
        )
        why = f"nothing known brings {name}: it may be there, and is left out where it is not"
        reasons.append(because("source", name, why, asked, weight=Weight.SOUGHT))
    answer = replace(found.answer, sought=(*found.answer.sought, *sought))
    return replace(found, answer=answer, reasons=(*found.reasons, *reasons))


def _lacking(
    evidence: Evidence, sources: Sources, packages: Packages, target: Target, system: SystemPackages
) -> dict[str, Dependency]:
    """Return what the program requires and nothing known brings, by its name, in the order in which it is named."""
    names = {plain(name) for name in provided(evidence, system, sources, (), target)}
    asked = (each for _, each in of_program(required_by_tool(evidence, "cpp"), packages))
    options = given(evidence)
    required = (each for each in asked if not (without_config(each, "cpp") or switch_of(each, options)))
    found: dict[str, Dependency] = {}
    for each in (*required, *_named(packages)):
        known = resolve(each, target).known or ever_released(each.name) or library("cmake", each.name, None)
        if not (known or provided_as(each.name, names)) and _NAME.fullmatch(each.name) and len(each.name) >= _SHORTEST:
            found.setdefault(plain(each.name), each)
    return {each.name: each for each in found.values()}


def _named(packages: Packages) -> Iterator[Dependency]:
    """Yield what manifests of plain CMake name as needed to build, and rosdep has not; no wrapper for catkin."""
    for manifest in (each for each in packages.built if types(each) == {"cmake"}):
        for each in manifest.dependencies:
            known = each.name in rosdep_keys() or each.name in packages.names
            if each.role == "build" and not (each.condition or known or wraps(each.name)):
                yield each
