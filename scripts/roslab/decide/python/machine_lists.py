"""Requirement files that list what a whole machine with ROS had installed: no index has ROS's own packages."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.knowledge.guesses import tooling

FEWEST = 3
"""Fewest of ROS's own packages, each of one version, that only such a list has: one or two may be a reader's wish."""


def of_machines(evidence: Evidence) -> frozenset[str]:
    """Return the paths of the lists that ``pip freeze`` made on such a machine, not a hand for the code."""
    own = tooling("ros")
    pinned = {
        file.file: [asked for asked in file.requirements if asked.written.startswith(f"{asked.name}==")]
        for file in evidence.requirements
    }
    return frozenset(path for path, found in pinned.items() if sum(asked.key in own for asked in found) >= FEWEST)


def machine_lists(evidence: Evidence, chosen: Collection[RequirementFile]) -> Iterator[Warning_]:
    """Yield a warning for each of the lists that is not among the chosen files."""
    why = "it lists what a machine with ROS had installed, ROS's own packages too, which pip cannot install"
    return not_installed(evidence, of_machines(evidence), chosen, why)


def not_installed(
    evidence: Evidence, lists: Collection[str], chosen: Collection[RequirementFile], why: str
) -> Iterator[Warning_]:
    """Yield a warning for each of these lists that is not among the chosen files."""
    for file in evidence.requirements:
        if file.file in lists and file not in chosen:
            yield warn(f"{file.file} is not installed: {why}; `requirements` in roslab.yaml installs it", file)
