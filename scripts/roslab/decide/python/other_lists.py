"""Versions of what the code imports, from lists of the tree that are not installed: a second environment of conda."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.pins import of_conda
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement


def as_in_list(guess: Requirement, evidence: Evidence) -> Requirement:
    """Return a guess as the other lists of the tree ask for it: ``robomimic==0.2.0``.

    The lists nearest to the import decide, where they agree; a guess that has a version keeps it.
    """
    if guess.limited or guess.specifier or guess.url:
        return guess
    said = [each for each in _listed(evidence) if each.key == guess.key]
    closest = max((_shared(each.file, guess.file) for each in said), default=0)
    near = [each for each in said if _shared(each.file, guess.file) == closest]
    if len({each.written for each in near}) != 1:
        return guess
    return replace(near[0], origin=guess.origin, role="", file=guess.file, line=guess.line)


def _listed(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what lists ask for in a version or from an address, wherever a program of the tree may run."""
    lists = [(file.file, file.requirements) for file in evidence.requirements if file.purpose == "run"]
    lists += [(each.file, (*each.requirements, *of_conda(each))) for each in evidence.conda]
    for file, asked in lists:
        if not places.vendored(file) and not places.aside(file):
            yield from (each for each in asked if each.package and each.name and _says(each))


def _says(asked: Requirement) -> bool:
    return bool(asked.specifier or asked.url) and asked.marker is None


def _shared(one: str, other: str) -> int:
    """Return how many folders two files have in common."""
    pairs = zip(one.split("/")[:-1], other.split("/")[:-1], strict=False)
    return next((at for at, (left, right) in enumerate(pairs) if left != right), min(one.count("/"), other.count("/")))
