"""What packages need to be built and only older distributions released: where nothing else tells, these decide."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.decide.ros.source_names import plain, telling_words
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.conditions import holds
from roslab.knowledge.distros import distros
from roslab.knowledge.libraries import library
from roslab.knowledge.released import ever_released, released, rosdep_keys
from roslab.knowledge.ros_sources import ros_sources


def with_every_package(evidence: Evidence, ros: int, answer: str, fitting: list[str]) -> tuple[str, Dependency] | None:
    """Return the best of the fitting distributions that released a package which the given one lacks, and who asks.

    ``None`` where that one has every package, or no other has, or something that is cloned is called like it.
    """
    lost = _lost(evidence, ros, answer)
    best = [name for name in fitting if lost.keys() <= released(name)]
    if not lost or not best:
        return None
    return max(best, key=lambda name: distros()[name].preference), lost[min(lost)]


def with_every_launched(evidence: Evidence, ros: int, answer: str, fitting: list[str]) -> tuple[str, Dependency] | None:
    """Return the best of the fitting distributions with all that the launch files need, and what the given one lacks.

    All but what no distribution of these released; ``None`` where the given one has that, or no other has.
    """
    own = packages_of(evidence).names
    asked = [each for launch in evidence.launch if launch.ros == ros and launch.package for each in launch.dependencies]
    needed: dict[str, Dependency] = {}
    for each in asked:
        ros_sister = each.name in own or _named(each.name, evidence) or ros_sources(each.name, ros, answer)
        if each.namespace == "ros" and each.strength != "optional" and not ros_sister:
            needed.setdefault(each.name, each)
    wanted = needed.keys() & {name for each in (answer, *fitting) for name in released(each)}
    lost = wanted - released(answer)
    best = [name for name in fitting if wanted <= released(name)]
    if not lost or not best:
        return None
    return max(best, key=lambda name: distros()[name].preference), needed[min(lost)]


def _lost(evidence: Evidence, ros: int, distro: str) -> Mapping[str, Dependency]:
    """Return what packages need to be built, a distribution released once, this one did not, and nothing brings."""
    packages = packages_of(evidence)
    variables = {"ROS_VERSION": str(ros)}
    there = packages.names | released(distro) | rosdep_keys()
    found: dict[str, Dependency] = {}
    for asked in (each for manifest in packages.built for each in manifest.dependencies):
        if asked.role != "build" or asked.name in there or not holds(asked.condition, variables):
            continue
        known = library("cmake", asked.name, None) is not None or ros_sources(asked.name, ros, distro)
        if not known and ever_released(asked.name) and not _named(asked.name, evidence):
            found.setdefault(asked.name, asked)
    return found


def _named(wanted: str, evidence: Evidence) -> bool:
    """Tell whether a repository that is cloned or linked to is called like a package, or like its family."""
    words = telling_words(wanted) | {plain(wanted)}
    return any(words & (telling_words(git.name) | {plain(git.name)}) for git in evidence.sources)
