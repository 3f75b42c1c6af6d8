"""Which of several distributions that are named has all packages that the manifests declare."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Reason
from roslab.decide.ros.distro_weights import Weight
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros
from roslab.knowledge.released import released
from roslab.values.dataclass import replace

_LATER = frozenset({"test", "doc"})


def complete(best: Reason, reasons: Iterable[Reason], keys: frozenset[str], evidence: Evidence) -> Reason:
    """Return the reason for the newest of those with the weight of the ``best`` that lacks no package, else the best.

    ``keys``: what only distributions of ROS can have; what none of those named has speaks against none. CI and an
    author's image bring by themselves what is lacking, and the list of rolling has gaps. Where none of that weight has
    all, it is one that is also said to be what the packages are for, and has all that they are compiled with.
    """
    if best.weight > Weight.RECOMMENDED or _rolling(best):
        return best
    named = [each for each in reasons if not _rolling(each)]
    alike = [each for each in named if each.weight == best.weight]
    less = [each for each in named if Weight.SPEAKS_OF_IT < each.weight <= best.weight]
    return (
        _full(best, alike, keys & _needed(evidence, _LATER))
        or _full(best, less, keys & _needed(evidence, _LATER | {"exec"}))
        or best
    )


def _full(best: Reason, named: Iterable[Reason], asked: frozenset[str]) -> Reason | None:
    """Return the heaviest reason for one that has all of these which any has, the newest, where the best has not."""
    named = {each.answer: each for each in sorted(named, key=lambda each: each.weight)}.values()
    asked &= frozenset().union(*(released(each.answer) for each in named))
    lacking = sorted(asked - released(best.answer))
    full = [each for each in named if asked <= released(each.answer)]
    if not lacking or not full:
        return None
    found = max(full, key=lambda each: (each.weight, distros()[each.answer].preference))
    why = f"{found.reason}; {best.answer}, which is named too, has no {', '.join(lacking[:3])}"
    return replace(found, reason=why, weight=best.weight + 1)


def _rolling(reason: Reason) -> bool:
    return distros()[reason.answer].never_ends


def _needed(evidence: Evidence, but: frozenset[str]) -> frozenset[str]:
    """Return what packages depend on, but in these roles alone."""
    declared = (each for manifest in packages_of(evidence).built for each in manifest.dependencies)
    return frozenset(each.name for each in declared if each.role not in but)
