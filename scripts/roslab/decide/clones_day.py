"""The day of what files of CMake clone without a commit or a tag: that of pip's packages."""

from __future__ import annotations

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence

WEIGHT = 300
"""Weight of the reason for each such clone; nothing competes with it."""


def decide_clones_day(evidence: Evidence, config: Config, build_tool: BuildTool) -> Choice[str]:
    """Return the day, ``""`` where CMake clones nothing so, or where the image is of today."""
    day = evidence.day or evidence.pip_day
    found = [mention for mention in evidence.mentions if mention.topic == "cloned_head"]
    if not (day and found) or config.compatible or build_tool in {"none", "pip", "conda"}:
        return Choice(answer="")
    why = f"CMake clones it without a commit: it is taken as it was on {day}, for the last commit here is old"
    return Choice(answer=day, reasons=tuple(because("source", each.value, why, each, weight=WEIGHT) for each in found))
