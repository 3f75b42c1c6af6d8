"""The distribution that the code itself names, in passing: a sign where only the date of the last commit tells else."""

from __future__ import annotations

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.distro_dates import dated, supported
from roslab.decide.ros.distro_weights import Weight
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import default_distro, distros


def by_code(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the distribution of a ROS version that code names alone of those that were there at the last commit.

    By the messages of its bags, and by the branch in the address of what it says that it was taken from, or in more
    than one address. Examples of a library name the one that was new then, so that without a date none older than the
    default counts; rolling tells nothing.
    """
    date = dated(evidence)

    def possible(name: str) -> bool:
        found = distros().get(name)
        if found is None or found.ros != ros or found.never_ends:
            return False
        return supported(name, date.value) if date else found.released >= default_distro(ros).released

    stores = [each for each in evidence.mentions if each.topic == "typestore" and possible(each.value)]
    links = [each for each in evidence.commented if possible(each.ref or "") and not places.aside(each.file)]
    found: list[Reason] = []
    if len({each.value for each in stores}) == 1:
        why = f"its code reads bags with the messages of {stores[0].value}: {stores[0].text}"
        found.append(because("ros_distro", stores[0].value, why, stores[0], weight=Weight.TYPESTORE))
    if len({each.ref for each in links}) == 1 and (len(links) > 1 or links[0].taken):
        name = links[0].ref or ""
        why = f"its code names {links[0].url} of the branch {name}"
        found.append(because("ros_distro", name, why, links[0], weight=Weight.ADDRESS))
    return found
