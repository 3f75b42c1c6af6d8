"""Bounds that old releases need and do not declare: torchvision 0.4 allows a Pillow that it cannot be loaded with."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Choice, Reason
from roslab.decide.python.bounds import Constraints, excluded
from roslab.decide.python.weights import PackageWeight
from roslab.decide.reasons import because
from roslab.knowledge.undeclared_limits import UndeclaredLimit, undeclared_limits
from roslab.values.requirement import Requirement
from roslab.values.version import Version


def decide_undeclared(asked: Iterable[Requirement]) -> Choice[Constraints]:
    """Return a bound for each package that an old release in ``asked`` needs so, unless the author limits that."""
    asked = tuple(asked)
    limited = {each.key for each in asked if each.limited}
    found: dict[str, tuple[Requirement, Reason]] = {}
    for each in asked:
        for known in undeclared_limits().get(each.key, ()) if not each.url else ():
            bound = known.limit
            if not _older(each, known) or bound.key in limited or excluded(bound, asked):
                continue
            why = f"{each.written} needs it, and does not say so"
            before = found.get(bound.key)
            if before is None or Version(bound.below or "0") < Version(before[0].below or "0"):
                found[bound.key] = bound, because("dependencies", bound.written, why, each, weight=PackageWeight.BOUND)
    return Choice(answer=tuple(bound for bound, _ in found.values()), reasons=tuple(why for _, why in found.values()))


def _older(asked: Requirement, known: UndeclaredLimit) -> bool:
    """Tell whether every release that a requirement allows is older than the first one that needs no such limit."""
    if asked.release:
        return Version(asked.release) < known.below
    if asked.below is None or Version(asked.below) > known.below:
        return False
    return not asked.specifier.contains(str(known.below), prereleases=True)
