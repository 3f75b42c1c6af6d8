"""The distribution of the author's machine: an editor's settings, and what a build wrote."""

from __future__ import annotations

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros

SETTINGS = 200
"""Weight of a path in settings or of a build: less than an Ubuntu that a page names, more than any date."""
DOUBTED = 30
"""Weight of each where several differ: the code moved on, and the date of the last commit tells more."""
DEEPER = 5


def on_machines(evidence: Evidence, ros: int) -> list[Reason]:
    """Return the distributions of a ROS version that files of the author's machine name."""
    said = [m for m in evidence.mentions if m.topic == "machine" and distros()[m.value].ros == ros]
    one = len({mention.value for mention in said}) == 1
    found = {}
    for mention in reversed(said):
        depth = mention.file.count("/") * (not mention.file.startswith("."))
        weight = SETTINGS - DEEPER * min(depth, 10) if one else DOUBTED
        why = f"on a machine of the author's: {mention.text}"
        found[mention.value] = because("ros_distro", mention.value, why, mention, weight=weight)
    return list(found.values())
