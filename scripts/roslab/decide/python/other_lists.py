"""Versions of what the code imports, from lists of the tree that are not installed: a second environment of conda."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

from roslab.decide.python.pins import of_conda
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.guesses import tooling
from roslab.knowledge.not_on_index import not_on_index
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def as_in_list(guess: Requirement, evidence: Evidence) -> Requirement:
    """Return a guess as the other lists of the tree ask for it: ``robomimic==0.2.0``.

    The lists nearest to the import decide, where they agree; a guess that has a version keeps it.
    """
    if guess.limited or guess.specifier or guess.url:
        return guess
    said = [each for each in _by_key(evidence).get(guess.key, ()) if _says(each)]
    closest = max((_shared(each.file, guess.file) for each in said), default=0)
    near = [each for each in said if _shared(each.file, guess.file) == closest]
    if len({each.written for each in near}) != 1:
        return guess
    return replace(near[0], origin=guess.origin, role="", file=guess.file, line=guess.line)


def named_in_list(evidence: Evidence, used: Dependency) -> str | None:
    """Return the package of a list of the tree that is called like a module which no table knows, ``None`` for none.

    Also of a list that is not installed as a whole: its author had that package. Of an extra of the project at the root
    only where its packages cannot do without: scripts beside them may be for who asks for more. Not one that pip's
    index lacks.
    """
    name = canonicalize_name(used.name)
    if name in not_on_index() or name in tooling("ros"):
        return None
    needed = used.strength == "used" and "/" in used.file and not places.aside(used.file)
    return name if name in _by_key(evidence) or (needed and name in _in_extras(evidence)) else None


def listed(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what lists ask for in a version or from an address, wherever a program of the tree may run."""
    yield from (each for each in _entries(evidence) if _says(each))


@lru_cache(maxsize=2)
def _by_key(evidence: Evidence) -> Mapping[str, Sequence[Requirement]]:
    """Return what the lists ask for by name: the code may import thousands of modules."""
    found: dict[str, list[Requirement]] = {}
    for asked in _entries(evidence, bounds=True):
        found.setdefault(asked.key, []).append(asked)
    return found


@lru_cache(maxsize=2)
def _in_extras(evidence: Evidence) -> frozenset[str]:
    """Return the names of what extras of the project at the root have from the index."""
    asked = (each for project in evidence.python if not project.folder for each in project.requirements)
    return frozenset(each.key for each in asked if each.role == "extra" and each.package and not each.url)


def _entries(evidence: Evidence, *, bounds: bool = False) -> Iterator[Requirement]:
    lists = [(file.file, file.requirements) for file in evidence.requirements if file.purpose == "run"]
    lists += [(each.file, (*each.requirements, *of_conda(each, bounds=bounds))) for each in evidence.conda]
    for file, asked in lists:
        if not places.vendored(file) and not places.aside(file):
            yield from (each for each in asked if each.package and each.name)


def _says(asked: Requirement) -> bool:
    return bool(asked.specifier or asked.url) and asked.marker is None


def _shared(one: str, other: str) -> int:
    """Return how many folders two files have in common."""
    pairs = zip(one.split("/")[:-1], other.split("/")[:-1], strict=False)
    return next((at for at, (left, right) in enumerate(pairs) if left != right), min(one.count("/"), other.count("/")))
