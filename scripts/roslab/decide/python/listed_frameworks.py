"""Releases of frameworks that the code imports, from lists of the tree that are not installed."""

from __future__ import annotations

from roslab.decide.python.other_lists import listed
from roslab.decide.python.packages import Chosen
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

FRAMEWORKS = frozenset({"torch", "tensorflow", "jax"})
_GPU, _CPU = "-gpu", "-cpu"
DEEPEST = 1
"""A list further down is of a part, whose framework may be another one."""


def as_listed(evidence: Evidence, chosen: Chosen, python: str | None) -> Chosen:
    """Return what is chosen with the releases of guessed frameworks that lists which are not installed pin.

    They have to agree, and the release needs a wheel for the chosen Python. One built for GPUs alone is taken by its
    plain name: in the images that are left, the CUDA that it loads is often another.
    """
    guessed = tuple(_pinned(evidence, each, python) for each in chosen.guessed)
    return replace(chosen, guessed=guessed) if guessed != chosen.guessed else chosen


def _pinned(evidence: Evidence, guess: Requirement, python: str | None) -> Requirement:
    if guess.key not in FRAMEWORKS or guess.origin != "import" or guess.specifier or guess.url or python is None:
        return guess
    names = {guess.key, f"{guess.key}{_GPU}", f"{guess.key}{_CPU}"}
    lists = [each for each in listed(evidence) if each.key in names and each.file.count("/") <= DEEPEST]
    if len({each.release for each in lists}) != 1:
        return guess
    release = lists[0].release or ""
    row = framework(guess.key, release) if release else None
    if row is None or not row.runs_with(python):
        return guess
    name = lists[0].key.removesuffix(_GPU)
    return stated(f"{name}=={release}", guess.origin, guess.file, guess.line)
