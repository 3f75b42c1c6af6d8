"""What CMake finds in wheels of cmeel, where CI, a page or a conda environment has these: not compiled from source.

Seen on 2026-11-28, with crocoddyl 3.2.1 and CMake 3.25: with ``cmeel.prefix`` in CMAKE_PREFIX_PATH a program is
configured and compiled, and finds the libraries by LD_LIBRARY_PATH alone.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from roslab.config.model import Kind
from roslab.decide.python.conda_environments import OF_OTHER_SYSTEM
from roslab.decide.system.recipes import own_names
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.own_places import PYTHON
from roslab.knowledge.cmeel_wheels import by_conda, cmeel_wheels, header_folders
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

PREFIX = "cmeel.prefix"
_PLACES = (f"/opt/venv/lib/python{PYTHON}/site-packages", f"/usr/local/lib/python{PYTHON}/dist-packages")
"""Where pip installs to: into the image's environment, or beside the packages of the system's Python."""
_VARIABLES = {"CMAKE_PREFIX_PATH": PREFIX, "LD_LIBRARY_PATH": f"{PREFIX}/lib"}
_BUILD = "build"
_SINCE = "2023-01-01"
"""From this day on pip's index has wheels of all of them; the environment of an older tree asks for older releases."""


def with_wheels(evidence: Evidence, kind: Kind, folder_name: str) -> Evidence:
    """Return the evidence of C++ with such wheels, and without what they bring: nothing else asks for that any more.

    They are taken where CMake asks for what one brings, and CI installs that with the extra ``build``, a page by pip or
    conda, or the conda environment has it that a page makes or that stands at the root.
    """
    wheels = _asked(evidence, folder_name) if kind == "cpp" else {}
    brought = frozenset(name for pip in wheels for name in cmeel_wheels()[pip])
    folders = brought.union(*(header_folders()[pip] for pip in wheels))
    if not wheels:
        return evidence
    first, _ = next(iter(wheels.values()))
    projects = (replace(each, dependencies=_without(each.dependencies, brought)) for each in evidence.cmake)
    manifests = (replace(each, dependencies=_without(each.dependencies, brought)) for each in evidence.manifests)
    linked = (each for each in evidence.sources if each.kind != "link" or canonicalize_name(each.name) not in brought)
    asked = tuple(
        stated(f"{pip}[{_BUILD}]{version}", "prose", place.file, place.line) for pip, (place, version) in wheels.items()
    )
    others = (each for each in evidence.prose_pip if each.key not in wheels)
    return replace(
        evidence,
        cmake=tuple(projects),
        manifests=tuple(manifests),
        sources=tuple(linked),
        code=tuple(each for each in evidence.code if not _is_header(each, folders)),
        prose_pip=(*others, *asked),
        mentions=(*evidence.mentions, *_variables(first)),
    )


def _asked(evidence: Evidence, folder_name: str) -> Mapping[str, tuple[Dependency, str]]:
    """Return the wheels, each with the first place at which CMake asks for what it brings, and the release of pip's."""
    own = {canonicalize_name(name) for name in own_names(evidence, folder_name)}
    required: dict[str, Dependency] = {}
    for project in evidence.cmake:
        for each in project.dependencies:
            if each.namespace == "cmake":
                required.setdefault(canonicalize_name(each.name), each)
    found: dict[str, tuple[Dependency, str]] = {}
    for said in (*evidence.prose_pip, *_of_environments(evidence)):
        pip = _wheel_of(said)
        names = sorted(cmeel_wheels().get(pip, frozenset()) & required.keys())
        if names and own.isdisjoint((pip, *names)):
            version = "" if said.role == "conda" else str(said.specifier)
            if not found.get(pip, ("", ""))[1]:
                found[pip] = required[names[0]], version
    return found


def _of_environments(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what the environments have that a page makes, and those at the root, each as conda calls it."""
    if evidence.pip_day and evidence.pip_day < _SINCE:
        return
    made = {each.written.removeprefix("./") for each in evidence.prose_pip if each.role == "environment"}
    for each in evidence.conda:
        meant = each.file in made or "/" not in each.file
        if meant and not each.system and not OF_OTHER_SYSTEM.search(each.file):
            yield from (stated(of.name, "conda", each.file, role="conda") for of in each.packages)


def _wheel_of(said: Requirement) -> str:
    """Return the wheel that a line asks for; one of CI has to ask for what is compiled with it."""
    if said.file.startswith("."):
        return said.key if _BUILD in said.extras else ""
    return by_conda().get(said.key, "") if said.role == "conda" else said.key if not said.role else ""


def _without(asked: Collection[Dependency], brought: frozenset[str]) -> tuple[Dependency, ...]:
    return tuple(each for each in asked if canonicalize_name(each.name) not in brought)


def _is_header(each: Dependency, folders: frozenset[str]) -> bool:
    return each.namespace in {"include", "nowhere"} and each.name.partition("/")[0] in folders


def _variables(place: Dependency) -> Iterator[Mention]:
    for name, below in _VARIABLES.items():
        value = ":".join(f"{folder}/{below}" for folder in _PLACES)
        yield Mention(
            topic="variable", value=f"{name}={value}", source="code", file=place.file, line=place.line, text=place.name
        )
