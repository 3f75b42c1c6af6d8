"""The distribution of ROS 2 that a named release of Gazebo was packaged for."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.distro_dates import dated
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import distros
from roslab.knowledge.gazebo_releases import gazebo_holding, gazebo_libraries, gazebo_pairs, gazebo_releases
from roslab.values.pattern import pattern

_ADDRESS = pattern(r"[\w./:-]*\.org/docs/[^\s<>()\"']*")


class Weight:
    """How much a release of Gazebo tells: it can be installed beside more than one distribution."""

    LIBRARY = 205  # CMake asks for it by its number
    NAMED = 200  # below an Ubuntu that the README names
    ADDRESS = 105  # only in a link to Gazebo's pages: below one to those of a distribution
    DEEPER = 5  # subtracted for each folder above the file


def by_gazebo(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the reason for the distribution of the one release of Gazebo that the tree names.

    None where it names releases for several distributions, or the distribution came only after the last commit: its
    release of Gazebo was then installed beside an older one.
    """
    if ros == 1:
        return []
    found = list(_asked(evidence))
    if len({reason.answer for reason in found}) != 1:  # none, or each where a variable says so: a page tells which
        found = list(_said(evidence)) or found
    answers = {reason.answer for reason in found}
    date = dated(evidence)
    if len(answers) != 1 or (date and distros()[next(iter(answers))].released > date.value):
        return []
    return [max(found, key=lambda reason: reason.weight)]


def without_library(evidence: Evidence) -> dict[str, frozenset[str]]:
    """Return, for each distribution whose release of Gazebo is known, the required libraries of other releases alone.

    A library that is required in several versions, each under a condition, is there where one of them is.
    """
    asked = _families(evidence)
    there: dict[str, set[str]] = {}
    for distro, release in (*((distro, release) for release, distro in gazebo_releases().items()), *gazebo_pairs()):
        there.setdefault(distro, set()).add(release)
    return {distro: _lacked(asked, releases) for distro, releases in there.items()}


def _families(evidence: Evidence) -> Collection[frozenset[str]]:
    """Return the libraries that CMake requires, the versions of one together."""
    asked: dict[str, set[str]] = {}
    for project in evidence.cmake:
        for each in project.dependencies if not places.vendored(project.file) else ():
            if each.strength != "optional" and each.role != "test" and each.name in gazebo_holding():
                family = each.name.rstrip("0123456789").replace("ignition-gazebo", "gz-sim")
                asked.setdefault(family, set()).add(each.name)
    return [frozenset(names) for names in asked.values()]


def _lacked(asked: Collection[frozenset[str]], releases: Collection[str]) -> frozenset[str]:
    """Return the libraries of which none of these releases of Gazebo has a version that is asked for."""
    return frozenset(min(names) for names in asked if all(gazebo_holding()[n].isdisjoint(releases) for n in names))


def required(evidence: Evidence) -> Iterator[tuple[str, Dependency]]:
    """Yield the releases of Gazebo whose libraries CMake requires, each with the library."""
    for project in evidence.cmake:
        for asked in project.dependencies if not places.vendored(project.file) else ():
            if asked.strength != "optional" and (release := gazebo_libraries().get(asked.name)):
                yield release, asked


def _asked(evidence: Evidence) -> Iterator[Reason]:
    for release, asked in required(evidence):
        why = f"it needs {asked.name} of Gazebo {release.capitalize()}"
        yield because("ros_distro", gazebo_releases()[release], why, asked, weight=Weight.LIBRARY)


def _said(evidence: Evidence) -> Iterator[Reason]:
    """Yield the releases that pages name, without those that lack what CMake requires."""
    asked = _families(evidence)
    for mention in evidence.mentions:
        lacks = mention.topic == "gazebo" and _lacked(asked, {mention.value})
        if mention.topic == "gazebo" and not lacks and not places.vendored(mention.file):
            why = f"Gazebo {mention.value.capitalize()}: “{mention.text[:120]}”"
            yield because("ros_distro", gazebo_releases()[mention.value], why, mention, weight=_weight(mention))


def _weight(mention: Mention) -> int:
    named = mention.value in _ADDRESS.sub("", mention.text).lower()
    weight = Weight.NAMED if named else Weight.ADDRESS
    return weight - Weight.DEEPER * mention.file.count("/") * (not mention.file.startswith("."))
