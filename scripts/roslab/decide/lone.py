"""The only program that there is, or that is the tree's own, where a page runs it."""

from __future__ import annotations

from roslab.decide.candidate import LAUNCHERS, Candidate, program_of
from roslab.decide.first_command import helps
from roslab.decide.sections import about_running


def alone(found: list[Candidate], ours: list[Candidate]) -> Candidate | None:
    """Return the only program that there is, if a page runs it whole: named like a test, it comes after no other.

    What converts or downloads is not meant, unless it is a node; nor is what a section about tests runs.
    """
    if len({program_of(c.argv) for c in found}) != 1:
        return None
    whole = (c for c in ours if c.strong and not c.cut and about_running(c.heading) >= 0)
    return next((c for c in whole if c.argv[0] in LAUNCHERS or not helps(c)), None)


def behind_others(found: list[Candidate], ours: list[Candidate]) -> Candidate | None:
    """Return the only program of the tree that pages run, where others' are started before it: drivers, a planner."""
    own = [c for c in ours if c.strong]
    only = alone(own, own)
    if only is None or only.argv[0] not in LAUNCHERS or helps(only):
        return None
    others = (c for c in found if c.strong and c not in own)
    return only if any(c.file == only.file and c.line < only.line for c in others) else None
