"""Which of several distributions that are named alike has all packages that the manifests declare."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Reason
from roslab.decide.ros.distro_weights import Weight
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros
from roslab.knowledge.released import released
from roslab.values.dataclass import replace


def complete(best: Reason, reasons: Iterable[Reason], keys: frozenset[str], evidence: Evidence) -> Reason:
    """Return the reason for the newest of those with the weight of the ``best`` that lacks no package, else the best.

    ``keys``: what only distributions of ROS can have; what none of those named has speaks against none. CI and an
    author's image bring by themselves what is lacking, and the list of rolling has gaps.
    """
    named = {each.answer: each for each in reasons if each.weight == best.weight and not _rolling(each)}
    if len(named) < 2 or best.answer not in named or best.weight > Weight.RECOMMENDED:
        return best
    asked = keys & _needed(evidence) & frozenset().union(*map(released, named))
    lacking = sorted(asked - released(best.answer))
    full = [name for name in named if asked <= released(name)]
    if not lacking or not full:
        return best
    found = named[max(full, key=lambda name: distros()[name].preference)]
    why = f"{found.reason}; {best.answer}, which is named too, has no {', '.join(lacking[:3])}"
    return replace(found, reason=why, weight=best.weight + 1)


def _rolling(reason: Reason) -> bool:
    return distros()[reason.answer].never_ends


def _needed(evidence: Evidence) -> frozenset[str]:
    """Return what packages depend on for more than their tests and their documentation."""
    declared = (each for manifest in packages_of(evidence).built for each in manifest.dependencies)
    return frozenset(each.name for each in declared if each.role not in {"test", "doc"})
