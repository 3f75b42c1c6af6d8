"""Dockerfiles of the author's for several distributions, none of which tells more: what else is said decides."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from roslab.decide.decision import Reason
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

QUOTED = 100
"""Most characters of what decides that are quoted."""


def of_equal_dockerfiles(best: Collection[Reason], every: Iterable[Reason], evidence: Evidence) -> list[Reason]:
    """Return the best reason for each distribution; of those of Dockerfiles that weigh the most alike, one weighs more.

    That is the one for which the strongest other reason speaks, of a file that is no Dockerfile: a page, a script.
    ``every``: all reasons, ``best`` the strongest for each distribution.
    """
    authored = {each.file for each in evidence.dockerfiles}
    most = max((reason.weight for reason in best), default=0)
    equal = {reason.answer for reason in best if reason.weight == most and reason.file in authored}
    if len(equal) < 2 or len(equal) < sum(reason.weight == most for reason in best):
        return list(best)
    others = sorted((r for r in every if r.answer in equal and r.file not in authored), key=lambda r: -r.weight)
    first = next(iter(others), None)
    if first is None or any(r.weight == first.weight and r.answer != first.answer for r in others):
        return list(best)
    said = f"; {first.reason[:QUOTED]} ({first.file})"
    return [replace(r, reason=r.reason + said, weight=r.weight + 1) if r.answer == first.answer else r for r in best]
