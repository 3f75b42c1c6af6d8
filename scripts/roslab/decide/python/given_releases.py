"""What a list or a project pins and what gives way: to roslab.yaml's ``pip``, to another pin, to nodes by apt."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.python.beside_nodes import Loose, beside_nodes
from roslab.decide.python.clashing_pins import clashing_pins
from roslab.decide.python.image_python import Manager
from roslab.decide.python.python2_lists import for_python2
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.requirement import Requirement

__all__ = ["Loose", "gives_way"]

_GIVES_WAY = "{asked} gives way to {given}, which `pip` in roslab.yaml names"


def gives_way(
    evidence: Evidence,
    kind: Kind,
    ubuntu: str | None,
    files: Iterable[RequirementFile],
    given: Iterable[Requirement],
    *,
    manager: Manager,
    python: str | None,
) -> Loose:
    """Return the lines that are installed without their version: for roslab.yaml, for other pins, and for nodes by apt.

    ``given``: what roslab.yaml names under ``pip``; ``python``: the version that the image runs.
    """
    files = tuple(files)
    loose: Loose = {}
    if manager == "system":
        loose = {**for_python2(files, python), **beside_nodes(evidence, kind, ubuntu, files)}
    else:
        loose = clashing_pins(evidence, python)
    return {**loose, **_given(evidence, given)}


def _given(evidence: Evidence, given: Iterable[Requirement]) -> Loose:
    """Return the lines of lists and projects that no release fulfils beside those of roslab.yaml.

    Each with what is told. The lists would be installed last, and so theirs would stay, or pip would find none.
    """
    named = {each.key: each for each in given if each.name and not each.url and each.specifier}
    if not named:
        return {}
    return {
        asked: warn(_GIVES_WAY.format(asked=asked.written, given=named[asked.key].written), asked)
        for asked in _asked(evidence)
        if asked.key in named and _contradict(asked, named[asked.key])
    }


def _asked(evidence: Evidence) -> Iterator[Requirement]:
    for file in evidence.requirements:
        yield from file.requirements
    for project in evidence.python:
        yield from project.requirements


def _contradict(asked: Requirement, given: Requirement) -> bool:
    if asked.url or not asked.specifier:
        return False
    if given.release and not asked.specifier.contains(given.release, prereleases=True):
        return True
    return bool(asked.release and not given.specifier.contains(asked.release, prereleases=True))
