"""Requirement files that pin one package to two releases: pip takes no such pair in one call."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from roslab.decide.decision import Warning_
from roslab.decide.python.manifests import resolve, with_includes
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.requirement import Requirement
from roslab.values.version import Version


def of_one_call(
    evidence: Evidence, files: Sequence[RequirementFile]
) -> tuple[tuple[RequirementFile, ...], tuple[RequirementFile, ...]]:
    """Return the files that pip takes together, and those left that contradict one of them.

    What the author's own Dockerfile installs wins, then the first of the files.
    """
    paths = {file.file for file in files}
    asked = [each for made in evidence.dockerfiles if made.purpose == "project" for each in made.requirements]
    authored = {resolve(each, paths) for each in asked if each.role == "file"}
    kept: list[RequirementFile] = []
    for file in sorted(files, key=lambda file: file.file not in authored):
        if not _contradiction(evidence, kept, file):
            kept.append(file)
    return tuple(file for file in files if file in kept), tuple(file for file in files if file not in kept)


def afterwards(
    evidence: Evidence, kept: Sequence[RequirementFile], left: Sequence[RequirementFile]
) -> Iterator[Requirement]:
    """Yield what only the files that are left name: it is installed one by one, where it can be."""
    named = {asked.key for file in with_includes(evidence, kept) for asked in file.requirements}
    for file in with_includes(evidence, left):
        yield from (asked for asked in file.requirements if asked.package and not asked.role and asked.key not in named)


def contradicting(
    evidence: Evidence, kept: Sequence[RequirementFile], left: Sequence[RequirementFile]
) -> Iterator[Warning_]:
    """Yield a warning for each file that is left, at the line that contradicts another file."""
    for file in left:
        if found := _contradiction(evidence, kept, file):
            one, other = found
            message = f"{file.file} pins {other.written}, and {one.file} {one.written}: that one is installed, and of"
            advice = "this file what can be beside it; give the right one under `requirements` in roslab.yaml"
            yield warn(f"{message} {advice}", other)


def _contradiction(
    evidence: Evidence, kept: Sequence[RequirementFile], file: RequirementFile
) -> tuple[Requirement, Requirement] | None:
    """Return the first pins of kept files and of another one that no release of the package fulfils."""
    before = {asked.key: asked for each in with_includes(evidence, kept) for asked in _pins(each)}
    for asked in (asked for each in with_includes(evidence, [file]) for asked in _pins(each)):
        one = before.get(asked.key)
        if one and Version(one.release or "0") != Version(asked.release or "0"):
            return one, asked
    return None


def _pins(file: RequirementFile) -> Iterator[Requirement]:
    for asked in file.requirements:
        exact = any(each.operator == "==" and "*" not in each.version for each in asked.specifier)
        if exact and asked.release and not asked.marker and not asked.role:
            yield asked
