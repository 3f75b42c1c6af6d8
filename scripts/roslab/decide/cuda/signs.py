"""Whether a repository computes on CUDA: a framework in its manifests, its code or its pages, or CUDA sources."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.cuda.cpu_releases import built_for_cpu, warn_of_cpu, without_gpus
from roslab.decide.decision import Warning_
from roslab.decide.python.pins import DEVELOPMENT
from roslab.decide.python.pythons import ANY
from roslab.evidence import places
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.accelerated import accelerated, by_extra, plugin_of_jax
from roslab.values.dataclass import dataclass
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_TENSORRT = pattern(r"Nv(?:Infer|OnnxParser)\w*\.h$")


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
        aside = places.vendored(project.file) or places.example(project.file) or project.lacks
        if "cuda" in project.macros and not aside:
            return Sign(file=project.file, line=project.line, why="its CMake needs CUDA")
    return None


def includes_tensorrt(evidence: Evidence) -> bool:
    """Tell whether code of C++ includes TensorRT, whose packages only NVIDIA's images of CUDA have a source of.

    https://github.com/NVIDIA/TensorRT/blob/main/docker/ubuntu-20.04.Dockerfile, read 2026-11-23.
    """
    headers = (used for used in evidence.code if used.namespace == "include" and _TENSORRT.match(used.name))
    return any(not places.aside(used.file) for used in headers)


def _named(evidence: Evidence) -> Iterator[Sign]:
    """Yield where a framework is named: to pip, to ``import``, to conda.

    A library that declares what it needs, without one, does not need that of its examples and scripts; beside a list at
    the root, those of examples say nothing.
    """
    everywhere = [*_pip(evidence, listed=False)]
    names = accelerated() - without_gpus(evidence, everywhere)
    if not _by_extra(evidence):
        names -= by_extra() | built_for_cpu(evidence, everywhere)
    declares = any(p.installable and not p.folder and _declared(p) for p in evidence.python)
    listed = declares or any(file.requirements and "/" not in file.file for file in _to_run(evidence))
    for asked in _pip(evidence, listed=listed):
        if asked.key in names and ANY.may(asked):
            yield Sign(file=asked.file, line=asked.line, why=f"it needs {asked.key}")
    for used in evidence.code:
        name = canonicalize_name(used.name) if used.namespace == "import" and used.strength == "used" else ""
        if name in names and not ((declares and places.beside(used.file)) or (listed and places.sample(used.file))):
            yield Sign(file=used.file, line=used.line, why=f"it needs {name}")
    for environment in evidence.conda:
        for package in environment.packages:
            if package.name in names:
                why = f"its environment has {package.name}"
                yield Sign(file=environment.file, line=environment.line, why=why)


def _by_extra(evidence: Evidence) -> bool:
    """Tell whether anything asks for the wheels for CUDA of what computes on the CPU without them, or names a CUDA."""
    asked = [*_pip(evidence, listed=False), *(each for project in evidence.python for each in project.requirements)]
    extras = (extra for each in asked if each.key in by_extra() for extra in each.extras)
    options = [each.written for each in asked if each.role == "option"]
    options += [option for file in evidence.requirements for option in file.options]
    builds = [each.release or "" for each in asked if each.key in by_extra()]
    builds += [package.written for each in evidence.conda for package in each.packages if package.name in by_extra()]
    return (
        any(extra.startswith(("cuda", "gpu")) for extra in extras)
        or any(plugin_of_jax(each.key) for each in asked)
        or any("cuda" in text for text in (*options, *builds))
        or any(mention.topic == "cuda" for mention in evidence.mentions)
    )


def warnings_of_cuda(evidence: Evidence) -> tuple[Warning_, ...]:
    """Return what to know where CUDA is spoken of and nothing computes on it."""
    return warn_of_cpu(evidence, _pip(evidence, listed=False))


def _declared(project: PythonProject) -> list[Requirement]:
    return [asked for asked in project.requirements if asked.role not in {"extra", "test"}]


def _to_run(evidence: Evidence) -> Iterator[RequirementFile]:
    return (file for file in evidence.requirements if file.purpose == "run")


def _pip(evidence: Evidence, *, listed: bool) -> Iterator[Requirement]:
    for project in evidence.python:
        if not places.vendored(project.file):
            yield from _declared(project) or project.requirements
    for file in _to_run(evidence):
        if not (listed and places.sample(file.file)):
            yield from file.requirements
    for environment in evidence.conda:
        yield from environment.requirements
    for asked in evidence.prose_pip:
        if not DEVELOPMENT.search(asked.file):  # what CI installs for its tests, the code may do without
            yield asked
    for authored in evidence.dockerfiles:
        if authored.purpose == "project":
            yield from authored.requirements
