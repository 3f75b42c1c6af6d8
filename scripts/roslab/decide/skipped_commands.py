"""Commands of packages that the author's own build leaves out: none of them is the default."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate
from roslab.decide.ros.skipped import skipped
from roslab.decide.ros.workspace import packages_of
from roslab.decide.unbuilt_packages import starts_one
from roslab.evidence.facts import Evidence


def without_skipped(candidates: Iterable[Candidate], evidence: Evidence, kind: Kind) -> list[Candidate]:
    """Return the commands without those of packages that the root page's or CI's build leaves out: drivers, usually.

    A page at the root that runs one all the same means it.
    """
    found = list(candidates)
    left = frozenset(skipped(evidence, packages_of(evidence), "colcon", ()) if kind == "ros2" else ())
    return [each for each in found if "/" not in each.file or not starts_one(each, left)]
