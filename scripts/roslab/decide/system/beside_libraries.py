"""The packages of an image in which libraries are built from their source: what these need, and none of them twice."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from roslab.config.model import Config, Source
from roslab.decide.decision import Choice
from roslab.decide.ros.source_names import plain
from roslab.decide.system.listed_here import told_of_page, too_old_for_page
from roslab.decide.system.names import Target
from roslab.decide.system.on_cuda import compiled_without
from roslab.decide.system.packages import SystemPackages
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.libraries import library
from roslab.knowledge.recipes import beside
from roslab.values.dataclass import replace
from roslab.values.name import bare_name

EIGEN = "libeigen3-dev"
"""Headers alone, which those of what is compiled with them include."""


def with_libraries(
    choice: Choice[SystemPackages],
    libraries: Sequence[tuple[Source, Dependency]],
    evidence: Evidence,
    config: Config,
    target: Target,
) -> Choice[SystemPackages]:
    """Add what the libraries that are built from their source need beside them, and leave out packages of the same.

    Two versions would be mixed. What CMake finds as packages of ROS keeps its keys.
    """
    built = frozenset(source.name for source, _ in libraries)
    names = "|".join(re.escape(bare_name(name)) for name in built)
    asked = (re.escape(need.name.lower().replace("_", "-")) for _, need in libraries if need.namespace == "cmake")
    twin = re.compile(rf"ros-[a-z]+-(?:lib)?(?:{'|'.join((names, *asked))})") if names else None
    key = re.compile(rf"lib(?:{names})") if names else None
    tabled = frozenset(source.name for source, _ in libraries if source.tabled)
    doubles = frozenset[str]() if config.compatible else _doubles(tabled, evidence, config, target)
    kept = {name for name in choice.answer.apt_guessed if twin is None or not twin.fullmatch(name)}
    needed = {*(name for library in built for name in beside(library)), *_of_headers(libraries)}
    kept |= needed.difference(choice.answer.apt)
    components = {each.name for made in evidence.cmake for each in made.dependencies if each.namespace == "ros"}
    skip = [name for name in choice.answer.rosdep if key and key.fullmatch(name) and name not in components]
    answer = replace(
        choice.answer,
        apt=tuple(name for name in choice.answer.apt if name not in doubles),
        apt_guessed=tuple(sorted(kept - doubles)),
        rosdep=tuple(name for name in choice.answer.rosdep if name not in skip),
        skip_keys=(*choice.answer.skip_keys, *skip),
    )
    sources = {plain(source.name) for source in config.source}
    if config.compatible:
        return replace(choice, answer=answer)
    told = compiled_without((source for source, _ in libraries), evidence, sources)
    of_page = told_of_page(tuple(too_old_for_page(evidence, target)), {*map(str.lower, built), *sources}, target)
    return replace(choice, answer=answer, warnings=(*choice.warnings, *filter(None, (told,)), *of_page))


def _of_headers(libraries: Sequence[tuple[Source, Dependency]]) -> frozenset[str]:
    """Return Eigen's package where a library of the table is compiled with it, for the headers of that include its own.

    Not where Eigen itself is built: code that includes such a library's headers alone looks for it nowhere.
    """
    tabled = [source for source, _ in libraries if source.tabled]
    itself = any(source.name == "eigen3" for source in tabled)
    return frozenset({EIGEN} if not itself and any(EIGEN in source.depends for source in tabled) else ())


def _doubles(built: Collection[str], evidence: Evidence, config: Config, target: Target) -> frozenset[str]:
    """Return Ubuntu's packages of what CMake finds in a library of the table, where no author names them.

    What apt installs for other packages stays.
    """
    asked = {each.name for made in evidence.cmake for each in made.dependencies if each.namespace == "cmake"}
    found = (library("cmake", name, target.ubuntu) for name in asked if name.lower() in built)
    named = {*config.apt, *(each.name for each in evidence.prose if each.namespace == "apt")}
    named |= {each.name for dockerfile in evidence.dockerfiles for each in dockerfile.dependencies}
    needed = {name for library in built for name in beside(library)}
    return frozenset(name for each in found if each for name in each.apt if name not in named | needed)
