"""Whether a repository computes on CUDA: a framework in its manifests, its code or its pages, or CUDA sources."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.pythons import ANY
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.accelerated import accelerated
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class Sign:
    """Where it shows, and what."""

    file: str
    line: int
    why: str


def sign_of_cuda(evidence: Evidence) -> Sign | None:
    """Return the first sign of CUDA, manifests before code before sources; ``None`` where there is none."""
    if found := next(_named(evidence), None):
        return found
    if evidence.cuda_files:
        return Sign(file=evidence.cuda_files[0], line=1, why="CUDA sources")
    for project in evidence.cmake:
        if "cuda" in project.macros and not places.vendored(project.file) and not places.example(project.file):
            return Sign(file=project.file, line=project.line, why="its CMake needs CUDA")
    return None


def _named(evidence: Evidence) -> Iterator[Sign]:
    """Yield where a framework is named: to pip, to ``import``, to conda."""
    names = accelerated()
    for asked in _pip(evidence):
        if asked.key in names and ANY.may(asked):
            yield Sign(file=asked.file, line=asked.line, why=f"it needs {asked.key}")
    for used in evidence.code:
        name = canonicalize_name(used.name) if used.namespace == "import" and used.strength == "used" else ""
        if name in names:
            yield Sign(file=used.file, line=used.line, why=f"it needs {name}")
    for environment in evidence.conda:
        for package in environment.packages:
            if package.name in names:
                why = f"its environment has {package.name}"
                yield Sign(file=environment.file, line=environment.line, why=why)


def _pip(evidence: Evidence) -> Iterator[Requirement]:
    for project in evidence.python:
        if not places.vendored(project.file):
            yield from project.requirements
    for file in evidence.requirements:
        if file.purpose != "vendored":
            yield from file.requirements
    for environment in evidence.conda:
        yield from environment.requirements
    yield from evidence.prose_pip
    for authored in evidence.dockerfiles:
        if authored.purpose == "project":
            yield from authored.requirements
