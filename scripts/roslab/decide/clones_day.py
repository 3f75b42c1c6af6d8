"""The day of what files of CMake and scripts of the tree clone without a commit or a tag: that of pip's packages."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Choice, OwnScript
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence

WEIGHT = 300
"""Weight of the reason for each such clone; nothing competes with it."""


def decide_clones_day(
    evidence: Evidence, config: Config, build_tool: BuildTool, scripts: Iterable[OwnScript] = ()
) -> Choice[str]:
    """Return the day, ``""`` where neither CMake nor a script that is run clones so, or where the image is of today."""
    day = evidence.day or evidence.pip_day
    if not day or config.compatible:
        return Choice(answer="")
    by_cmake = build_tool not in {"none", "pip", "conda"}
    found = [mention for mention in evidence.mentions if mention.topic == "cloned_head" and by_cmake]
    run = {script.path for script in scripts}
    cloned = [git for git in evidence.sources if git.kind == "clone" and git.file in run and not git.ref]
    why = f"{{}} clones it without a commit: it is taken as it was on {day}, for the last commit here is old"
    reasons = (
        *(because("source", each.value, why.format("CMake"), each, weight=WEIGHT) for each in found),
        *(because("source", git.url, why.format(git.file), git, weight=WEIGHT) for git in cloned),
    )
    return Choice(answer=day if reasons else "", reasons=reasons)
