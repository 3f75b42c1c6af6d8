"""The distribution of ROS 2 that a named release of Gazebo was packaged for."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.distro_dates import dated
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.distros import distros
from roslab.knowledge.gazebo_releases import gazebo_libraries, gazebo_releases
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
    found = list(_asked(evidence)) or list(_said(evidence))
    answers = {reason.answer for reason in found}
    date = dated(evidence)
    if len(answers) != 1 or (date and distros()[next(iter(answers))].released > date.value):
        return []
    return [max(found, key=lambda reason: reason.weight)]


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
    for mention in evidence.mentions:
        if mention.topic == "gazebo" and not places.vendored(mention.file):
            why = f"Gazebo {mention.value.capitalize()}: “{mention.text[:120]}”"
            yield because("ros_distro", gazebo_releases()[mention.value], why, mention, weight=_weight(mention))


def _weight(mention: Mention) -> int:
    named = mention.value in _ADDRESS.sub("", mention.text).lower()
    weight = Weight.NAMED if named else Weight.ADDRESS
    return weight - Weight.DEEPER * mention.file.count("/") * (not mention.file.startswith("."))
