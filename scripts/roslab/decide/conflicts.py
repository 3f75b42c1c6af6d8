"""Files of Python that hold the markers of a merge that nobody finished."""

from __future__ import annotations

from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence

MOST = 5


def decide_conflicts(evidence: Evidence) -> Choice[None]:
    """Return a warning for each such file: nothing that imports it starts."""
    found = [mention for mention in evidence.mentions if mention.topic == "conflict"]
    message = "has the markers of a merge that nobody finished: Python refuses it, and what imports it stops"
    told = tuple(warn(f"{mention.value} {message}; keep one of the two sides", mention) for mention in found[:MOST])
    return Choice(answer=None, warnings=told)
