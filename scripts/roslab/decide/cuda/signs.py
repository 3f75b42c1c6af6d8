"""Whether a repository computes on CUDA: a framework in its manifests, its code or its pages, or CUDA sources."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from roslab.evidence import places
from roslab.evidence.facts import Dependency, Evidence
from roslab.knowledge.accelerated import accelerated

_STEM = re.compile(r"[A-Za-z0-9._-]+")


@dataclass(frozen=True, kw_only=True, slots=True)
class Framework:
    """Where it shows, and what."""

    file: str
    line: int
    why: str


def framework(evidence: Evidence) -> Framework | None:
    """Return the first sign of CUDA, manifests before code before sources; ``None`` where there is none."""
    names = accelerated()
    for dependency in _pip(evidence):
        stem = _stem(dependency.name)
        if stem in names:
            return Framework(file=dependency.file, line=dependency.line, why=f"it needs {stem}")
    for environment in evidence.conda:
        for package in environment.packages:
            if (stem := _stem(package)) in names:
                return Framework(file=environment.file, line=environment.line, why=f"its environment has {stem}")
    if evidence.cuda_files:
        return Framework(file=evidence.cuda_files[0], line=1, why="CUDA sources")
    for project in evidence.cmake:
        if "cuda" in project.macros and not places.vendored(project.file) and not places.example(project.file):
            return Framework(file=project.file, line=project.line, why="its CMake needs CUDA")
    return None


def _stem(requirement: str) -> str:
    match = _STEM.match(requirement.rpartition("::")[2])
    return match[0].lower().replace("_", "-") if match else ""


def _pip(evidence: Evidence) -> Iterator[Dependency]:
    for project in evidence.python:
        if not places.vendored(project.file):
            yield from project.dependencies
    for file in evidence.requirements:
        if file.purpose != "vendored":
            yield from file.dependencies
    for environment in evidence.conda:
        yield from environment.dependencies
    yield from (d for d in evidence.prose if d.namespace == "pip")
    for authored in evidence.dockerfiles:
        if authored.purpose == "project":
            yield from (d for d in authored.dependencies if d.namespace == "pip")
    yield from (d for d in evidence.code if d.namespace == "import" and d.strength == "used")
