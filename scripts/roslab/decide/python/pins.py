"""What the repository says of its Python packages, from every source, the most trusted first."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from roslab.evidence import places
from roslab.evidence.facts import CondaEnvironment, Dependency, Evidence
from roslab.knowledge.frameworks import canonical, conda_names, imports

_EXACT = re.compile(r"(?:===?|~=)\s*v?(\d[\w.]*(?:\+[\w.]+)?)")
_UPPER = re.compile(r"<=?\s*(\d[\w.]*)")
_CONDA = re.compile(r"^(?:[\w-]+::)?([A-Za-z0-9][\w.-]*)\s*(?:[=<>~! ]+\s*(\d[\w.+-]*))?")
MAX_FILES = 60
"""Requirement files that are weighed, the nearest to the root first."""
_NOT_OURS = frozenset({"vendored", "documentation", "ci"})
DEVELOPMENT = re.compile(r"(?:^|/)(?:\.github|\.circleci|\.ci|ci)(?:/|$)|(?:^|/)docs?/(?!.*\.(?:md|rst)$)")
"""What makes the documentation and runs in CI; a page of the documentation that tells how to install is none of it."""


class Pin(NamedTuple):
    """One mention of a Python package."""

    name: str
    """As the index compares it."""
    release: str | None
    """The release it is pinned to, with its local part; ``None`` where it is free."""
    below: str | None
    """Upper bound of its specifier."""
    line: str
    """The requirement line."""
    dependency: Dependency
    trust: int
    """3: a manifest of the project; 2: its conda environment; 1: README and Dockerfiles; 0: other files of the tree."""


def name_of(line: str) -> str:
    """Return the package a requirement line names, ``""`` for a bare URL without one."""
    if match := re.search(r"#egg=([\w.-]+)", line):
        return canonical(match[1])
    if re.match(r"^(?:git\+|https?:|file:|[./])", line):
        if wheel := re.search(r"/([A-Za-z0-9_.]+?)-\d[^/]*\.whl", line):
            return canonical(wheel[1])
        if git := re.search(r"/([\w.-]+?)(?:\.git)?(?:@[^/]*)?(?:#.*)?$", line):
            return canonical(git[1])
        return ""
    match = re.match(r"^([A-Za-z0-9](?:[A-Za-z0-9._-]*[A-Za-z0-9])?)", line)
    return canonical(match[1]) if match else ""


def pins(evidence: Evidence) -> Iterator[Pin]:
    """Yield every mention, the most trusted first; tests', documentation's and copies' files are left out."""
    found = [*_of_files(evidence), *_of_projects(evidence), *_of_conda(evidence), *_of_prose(evidence)]
    yield from sorted((pin for pin in found if pin.name), key=lambda pin: -pin.trust)


def _of_files(evidence: Evidence) -> Iterator[Pin]:
    own = sorted((f for f in evidence.requirements if f.purpose == "run"), key=lambda f: (f.file.count("/"), f.file))
    for file in own[:MAX_FILES]:
        trust = 0 if places.example(file.file) else {0: 3, 1: 2}.get(file.file.count("/"), 0)
        yield from (_pin(dependency, trust) for dependency in file.dependencies)


def _of_projects(evidence: Evidence) -> Iterator[Pin]:
    for project in evidence.python:
        if places.vendored(project.file) or places.example(project.file) or places.test(project.file):
            continue
        trust = 1 if project.folder else 3
        for dependency in project.dependencies:
            yield _pin(dependency, 0 if dependency.role.startswith(("extra", "test")) else trust)


def _of_conda(evidence: Evidence) -> Iterator[Pin]:
    for environment in evidence.conda:
        if not places.vendored(environment.file):
            trust = 2 if environment.file.count("/") <= 1 else 0
            yield from (_pin(dependency, trust) for dependency in environment.dependencies)
            yield from conda_pins(environment, trust)


def _of_prose(evidence: Evidence) -> Iterator[Pin]:
    known = {canonical(package) for package, _ in imports().values() if package}
    said = [d for r in evidence.dockerfiles if r.purpose not in _NOT_OURS for d in r.dependencies]
    said += [d for d in evidence.prose if not DEVELOPMENT.search(d.file)]
    for dependency in said:
        if dependency.namespace == "pip" and dependency.role in {"", "conda"}:
            pin = _pin(dependency, 1)
            if not dependency.role or pin.name in known:  # of "conda install", only what pip has by that name
                yield pin


def conda_pins(environment: CondaEnvironment, trust: int = 2) -> list[Pin]:
    """Return conda's own packages, by the names that the index has for them; Python itself and CUDA are none."""
    found = (_conda_pin(package, environment.file, trust) for package in environment.packages)
    return [pin for pin in found if pin]


def _pin(dependency: Dependency, trust: int) -> Pin:
    line = dependency.name
    exact = _EXACT.search(line.partition(";")[0])
    release = exact[1].rstrip(".*") if exact else None
    if wheel := re.search(r"/[A-Za-z0-9_.]+?-(\d[\d.]*(?:(?:\+|%2[bB])\w+)?)[^/]*\.whl", line):
        release = wheel[1].replace("%2B", "+").replace("%2b", "+")
    upper = _UPPER.search(line)
    return Pin(name_of(line), release, upper[1] if upper else None, line, dependency, trust)


def _conda_pin(package: str, file: str, trust: int) -> Pin | None:
    match = _CONDA.match(package)
    known = conda_names().get(match[1].lower(), match[1]) if match else None
    if match is None or known is None:
        return None
    name = canonical(known)
    release = match[2].partition("=")[0] if match[2] and re.match(r"^[^<>!]*=", package[match.end(1) :]) else None
    dependency = Dependency(namespace="pip", name=name, strength="declared", file=file, line=1, role="conda")
    return Pin(name, release, None, f"{name}=={release}" if release else name, dependency, trust)
