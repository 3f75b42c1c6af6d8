"""The distributions that CMake chooses between: the code is made for each, so that none of them tells much."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros

SEVERAL = 60
"""Weight where there are several: below a link to one, above the date of the last commit."""
ALONE = 25
"""Weight of one: it may be the exception, so that the date of the last commit tells more."""


def by_comparison(evidence: Evidence, ros: int) -> Iterator[Reason]:
    """Yield the reason for each distribution of a ROS version that CMake compares the environment's with."""
    found = {m.value: m for m in reversed(evidence.mentions) if m.topic == "compared" and distros()[m.value].ros == ros}
    for name, mention in found.items():
        weight = SEVERAL if len(found) > 1 else ALONE
        yield because("ros_distro", name, f"CMake asks for it: {mention.text}", mention, weight=weight)
