"""Indexes with the torch of one CUDA, which a page has pip use in place of its own: ``--index-url …/whl/cu118``."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.cuda.local import cuda_of
from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import Evidence
from roslab.evidence.locked import Locked
from roslab.knowledge.frameworks import framework, newest_framework
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement

_TORCH = "torch"


def ended_index(
    evidence: Evidence, wheels: Iterable[Requirement], python: str | None, day: str | None, below: str | None
) -> str | None:
    """Return the CUDA of the index from which pages take a torch of no version, if newer ones are not built for it.

    The image has pip's own index, too, and pip would take the newest torch of the two. Not beside a lock of torch.
    """
    torch = next((each for each in wheels if each.key == _TORCH and not each.url), None)
    if torch is None or torch.limited or _of_lock(evidence.locked):
        return None
    options = (
        each.written for each in evidence.prose_pip if each.role == "option" and not DEVELOPMENT.search(each.file)
    )
    found = {cuda for each in options if each.startswith("--index-url") and (cuda := cuda_of(each))}
    newest = newest_framework(_TORCH, day, python, below)
    ended = {cuda for cuda in found if newest and cuda not in newest.cuda}
    return next(iter(ended)) if len(found) == len(ended) == 1 else None


def without_unlocked(evidence: Evidence) -> Evidence:
    """Return the evidence without indexes of pages in folders that have no build of the torch which a lock has.

    A page below tells of another machine or of another time, and the lock is what its author runs. What the page says
    of CUDA on that line goes as well.
    """
    release = _of_lock(evidence.locked)
    row = framework(_TORCH, release) if release and "+" not in release else None
    if row is None:
        return evidence
    options = [each for each in evidence.prose_pip if each.role == "option" and "/" in each.file]
    left = {each for each in options if (cuda := cuda_of(each.written)) and cuda not in row.cuda}
    if not left:
        return evidence
    at = {(each.file, each.line) for each in left}
    mentions = tuple(m for m in evidence.mentions if m.topic != "cuda" or (m.file, m.line) not in at)
    return replace(
        evidence, prose_pip=tuple(each for each in evidence.prose_pip if each not in left), mentions=mentions
    )


def _of_lock(locked: Iterable[Locked]) -> str | None:
    """Return the one release of torch in locks."""
    found = {each.requirement.release for each in locked if each.requirement.key == _TORCH}
    return next(iter(found)) if len(found) == 1 else None
