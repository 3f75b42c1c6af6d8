"""The distribution of the author's machine: settings, what a build wrote, scripts, the list of a ``pip freeze``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.on_machines import is_link
from roslab.knowledge.distros import distros
from roslab.knowledge.ros_versions import versions, with_version
from roslab.values.origin import Place
from roslab.values.requirement import Requirement
from roslab.values.version import InvalidVersion, Version

SETTINGS = 200
"""Weight of a path in settings or of a build: less than an Ubuntu that a page names, more than any date."""
LINK = 395
"""Weight of catkin's own link: the author ran catkin there. The root's page of what it was tested on tells more, what
the pages of the packages below say tells less."""
DOUBTED = 30
"""Weight of each where several differ: the code moved on, and the date of the last commit tells more."""
FROZEN = 210
"""Weight of such a list: it is of one machine alone."""
DEEPER = 5
FEWEST = 2
"""Fewest of ROS's packages in a list whose versions are of one distribution: PyPI has others of the same name."""


def on_machines(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the distributions of a ROS version that files of the author's machine name."""
    said = [m for m in evidence.mentions if m.topic == "machine" and distros()[m.value].ros == ros]
    links = [mention for mention in said if is_link(mention)]
    said = links if len({mention.value for mention in links}) == 1 else said
    one = len({mention.value for mention in said}) == 1
    found = {}
    for mention in reversed(said):
        depth = mention.file.count("/") * (not mention.file.startswith("."))
        weight = (LINK if is_link(mention) else SETTINGS) - DEEPER * min(depth, 10) if one else DOUBTED
        why = f"on a machine of the author's: {mention.text}"
        found[mention.value] = because("ros_distro", mention.value, why, mention, weight=weight)
    return [*found.values(), *_frozen(evidence, ros)]


def _frozen(evidence: Evidence, ros: int) -> Iterator[Reason]:
    """Yield the distribution whose packages a list of ``pip freeze`` has, by the versions of most of them."""
    for file in evidence.requirements:
        pinned = [each for each in file.requirements if each.written.startswith(f"{each.name}==")]
        told = [(each, _with_version(each, ros)) for each in pinned if versions(each.name)]
        counted = Counter(name for _, names in told for name in names)
        most = [name for name, times in counted.items() if times == max(counted.values())]
        if len(most) != 1 or counted[most[0]] < FEWEST or places.vendored(file.file):
            continue
        of_it = [each for each, names in told if most[0] in names]
        why = f"{file.file} has versions of {most[0]}'s packages: {', '.join(each.written for each in of_it[:3])}"
        place = Place(file=file.file, line=of_it[0].line)
        yield because("ros_distro", most[0], why, place, weight=FROZEN)


def _with_version(asked: Requirement, ros: int) -> frozenset[str]:
    try:
        version = Version(asked.written.partition("==")[2])
    except InvalidVersion:
        return frozenset()
    return with_version(asked.name, version, ros)
