"""Lists that a page has pip install into the conda environment that it has made right above."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import pairwise

from roslab.decide.python.manifests import resolve, with_includes
from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import Evidence
from roslab.values.requirement import Requirement

_NEAR = 2
"""Fewest lines between two commands of different blocks: the end of one, or a line between them."""


def after_conda(evidence: Evidence, conda: str | None, known: Collection[str]) -> Iterator[Requirement]:
    """Yield what such lists have beyond the ``known`` names; they need not fit what conda has brought.

    Only where each line between is one that was read, or a single other: what stands in a block of its own may be for
    those who have no conda.
    """
    if conda is None:
        return
    files = {file.file: file for file in evidence.requirements if file.purpose == "run"}
    found: dict[str, Requirement] = {}
    for asked in evidence.prose_pip:
        path = resolve(asked, files) if asked.role == "file" and not DEVELOPMENT.search(asked.file) else None
        if path and any(_follows(asked, each, evidence) for each in evidence.prose_pip if _makes(each, conda)):
            for file in with_includes(evidence, [files[path]]):
                found |= {each.key: each for each in file.requirements if each.name and each.role in {"", "source"}}
    yield from (each for key, each in found.items() if key not in known)


def _makes(asked: Requirement, conda: str) -> bool:
    return asked.role == "environment" and resolve(asked, {conda}) == conda


def _follows(asked: Requirement, made: Requirement, evidence: Evidence) -> bool:
    """Tell whether a line stands in the same run of commands below another."""
    if made.file != asked.file or made.line >= asked.line:
        return False
    read = {each.line for each in evidence.prose_pip if each.file == asked.file}
    read |= {each.line for each in evidence.mentions if each.file == asked.file}
    lines = sorted(line for line in read if made.line <= line <= asked.line)
    return all(after - before <= _NEAR for before, after in pairwise(lines))
