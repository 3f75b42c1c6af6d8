"""Mentions of Python packages from every source, the most trusted first."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.by_siblings import by_siblings
from roslab.decide.python.pythons import ANY
from roslab.evidence import places
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.frameworks import conda_names, framework_on_cuda, imports, released_together, tabled, unstated
from roslab.knowledge.guesses import same_module
from roslab.knowledge.never_by_name import never_by_name
from roslab.knowledge.other_backends import other_backends
from roslab.knowledge.released import ever_released
from roslab.knowledge.standard_modules import standard_modules
from roslab.values.conda import CondaPackage
from roslab.values.dataclass import dataclass, replace
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.specifier import specifiers

MAX_FILES = 60
"""Most requirement files that are considered, those nearest to the root first."""
_NOT_OURS = frozenset({"vendored", "documentation", "ci"})
_DEVCONTAINER = pattern(r"(?:^|/)\.devcontainer/")
"""What the author works in."""
DEVELOPMENT = pattern(r"(?:^|/)(?:\.github|\.circleci|\.ci|ci)(?:/|$)|(?:^|/)docs?/(?!.*\.(?:md|rst)$)")
"""Files that build the documentation or run in CI; a documentation page on how to install is not one of them."""


@dataclass(frozen=True, slots=True)
class Pin:
    """One mention of a Python package."""

    requirement: Requirement
    trust: int
    """3: a manifest of the project; 2: its conda environment; 1: README and Dockerfiles; 0: other files of the tree,
    and a lock."""

    @property
    def name(self) -> str:
        """Normalised name."""
        return self.requirement.key

    @property
    def release(self) -> str | None:
        """The release it is pinned to, with its local part; ``None`` if it is not pinned."""
        return self.requirement.release


def pins(evidence: Evidence) -> tuple[Pin, ...]:
    """Return every mention, the most trusted first, without files of tests, documentation and vendored code.

    Requirements whose markers exclude every image are left out.
    """
    found = [*_of_files(evidence), *_of_projects(evidence), *_of_conda(evidence), *_of_prose(evidence)]
    found += _of_lock(evidence)
    kept = [pin for pin in found if pin.requirement.name and ANY.may(pin.requirement)]
    return tuple(sorted((*kept, *_unstated(kept, evidence)), key=lambda pin: -pin.trust))


def _unstated(found: list[Pin], evidence: Evidence) -> Iterator[Pin]:
    """Yield what packages need and do not ask pip for, each as a line of a page beside theirs, unless it is named.

    What is named in any version gets the limit of the package that needs it, but for frameworks: other rules pin them.
    A framework that no code imports is not needed beside another one that the package works with.
    """
    imported = {canonicalize_name(each.name) for each in evidence.code if each.namespace == "import"}
    names = {tabled(pin.name) for pin in found if pin.trust}
    limited = {tabled(pin.name) for pin in found if pin.trust and pin.requirement.limited}
    for pin in found:
        needs = unstated().get(pin.name) if pin.trust else None
        if needs is None:
            continue
        if other_backends().get(pin.name) in names and stated(needs).key not in imported:
            continue
        asked = stated(needs, "prose", pin.requirement.file, pin.requirement.line)
        if asked.key not in names:
            yield Pin(asked, 1)
        elif asked.limited and asked.key not in limited and not framework_on_cuda(asked.key):
            yield Pin(replace(asked, role="bounded"), 1)
        names.add(asked.key)
        limited.add(asked.key)


def _of_files(evidence: Evidence) -> Iterator[Pin]:
    own = sorted((f for f in evidence.requirements if f.purpose == "run"), key=lambda f: (f.file.count("/"), f.file))
    for file in own[:MAX_FILES]:
        trust = 0 if places.example(file.file) else {0: 3, 1: 2}.get(file.file.count("/"), 0)
        yield from (Pin(asked, trust) for asked in file.requirements)


def _of_projects(evidence: Evidence) -> Iterator[Pin]:
    for project in evidence.python:
        if places.aside(project.file):
            continue
        trust = 1 if project.folder else 3
        yield from (Pin(asked, 0 if asked.role in {"extra", "test"} else trust) for asked in project.requirements)


def _of_conda(evidence: Evidence) -> Iterator[Pin]:
    for environment in evidence.conda:
        if not places.vendored(environment.file):
            trust = 2 if environment.file.count("/") <= 1 else 0
            yield from (Pin(asked, trust) for asked in (*environment.requirements, *of_conda(environment)))


def _of_prose(evidence: Evidence) -> Iterator[Pin]:
    said = [asked for r in _images(evidence) for asked in r.requirements]
    said += [asked for asked in evidence.prose_pip if not DEVELOPMENT.search(asked.file)]
    by_conda = any(asked.role == "conda" for asked in said)
    known = {canonicalize_name(package) for package, _ in imports().values() if package} if by_conda else set()
    known |= _imported(evidence) if by_conda else set()
    for asked in by_siblings(said):  # from "conda install" only packages that pip has too
        if not asked.role or (asked.role == "conda" and asked.key in known):
            yield Pin(asked, 1)
    yield from _of_lists(evidence, {asked.key for asked in said})


def _imported(evidence: Evidence) -> set[str]:
    """Return the modules of no table that the code imports: conda's package of that name is called so by pip, too."""
    used = {each.name for each in evidence.code if each.namespace == "import" and each.strength == "used"}
    return {
        canonicalize_name(name)
        for name in used - imports().keys()
        if not (never_by_name(name) or ever_released(name) or name in standard_modules())
    }


def _images(evidence: Evidence) -> Iterator[AuthorDockerfile]:
    """Yield the Dockerfiles that may say what the project needs.

    One of an example, and that of the container that it is developed in, only where nothing else says it.
    """
    listed = bool(evidence.requirements or evidence.conda or evidence.python)
    for authored in evidence.dockerfiles:
        developed = authored.purpose == "ci" and _DEVCONTAINER.search(authored.file)
        ours = authored.purpose not in _NOT_OURS or developed
        if ours and not (listed and (developed or places.example(authored.file))):
            yield authored


def _of_lock(evidence: Evidence) -> Iterator[Pin]:
    """Yield the frameworks that a lock at the root has, and what is released with them: they need a CUDA."""
    beside = {name for names in released_together().values() for name in names}
    for each in evidence.locked:
        if framework_on_cuda(each.requirement.key) or each.requirement.key in beside:
            yield Pin(each.requirement, 0)


def _of_lists(evidence: Evidence, named: set[str]) -> Iterator[Pin]:
    """Yield what a page lists: what the code imports, and of a program of Python alone the rest too.

    The versions of its sentences count for what the code imports, a manifest asks for, or a line installs (``named``).
    """
    if not evidence.listed:
        return
    used = {d.name for d in evidence.code if d.namespace == "import"}
    imported = {canonicalize_name(package) for name, (package, _) in imports().items() if package and name in used}
    whole = bool(used) and not (evidence.requirements or evidence.conda or evidence.cmake)
    named = named | {asked.key for file in evidence.requirements for asked in file.requirements}
    named |= {asked.key for project in evidence.python for asked in project.requirements}
    named |= {asked.key for environment in evidence.conda for asked in environment.requirements}
    for asked in evidence.listed:
        if asked.role == "bounded" and asked.key not in {*named, *imported}:
            continue
        if (
            whole
            or asked.role == "bounded"
            or asked.key in imported
            or any(same_module(asked.key, other) for other in imported)
        ):
            yield Pin(asked, 1)


def of_conda(environment: CondaEnvironment, *, bounds: bool = False) -> list[Requirement]:
    """Return conda's own packages under the names on pip's index, without Python and CUDA.

    Those that are pinned with their releases; ``bounds``: those with a range with it, too, as pip reads it.
    """
    found = (_for_pip(package, environment.file, bounds=bounds) for package in environment.packages)
    return [asked for asked in found if asked]


def _for_pip(package: CondaPackage, file: str, *, bounds: bool) -> Requirement | None:
    known = conda_names().get(package.name, package.name)
    if known is None or not known[:1].isalnum():
        return None
    name, release = canonicalize_name(known), package.release
    said = f"=={release}" if release else package.bounds if bounds and specifiers(package.bounds) else ""
    return stated(f"{name}{said}", "conda", file, role="conda")
