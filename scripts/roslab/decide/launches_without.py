"""What pages start that needs packages which CMake cannot configure: others of the page are meant before it."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.decide.candidate import LAUNCHERS, Candidate
from roslab.decide.launch_calls import started_launch
from roslab.decide.ros.without_code import unconfigurable
from roslab.decide.ros.workspace import packages_of
from roslab.decide.unbuilt_packages import starts_one
from roslab.evidence.facts import Evidence


def without_unconfigurable(candidates: Sequence[Candidate], evidence: Evidence) -> list[Candidate]:
    """Return the commands without those that start such a package, or a launch file that needs one.

    All of them, where no other that a page runs starts something of a package.
    """
    found = [*candidates]
    stopped = unconfigurable(evidence, packages_of(evidence))
    if not stopped:
        return found
    kept = [each for each in found if not (starts_one(each, stopped) or _needs(each, stopped, evidence))]
    return kept if any(each.strong and each.argv[0] in LAUNCHERS for each in kept) else found


def _needs(candidate: Candidate, stopped: frozenset[str], evidence: Evidence) -> bool:
    launch = started_launch(evidence, candidate.argv)
    asked = (*launch.dependencies, *launch.reached) if launch else ()
    return any(each.name in stopped and each.namespace == "ros" and each.strength != "optional" for each in asked)
