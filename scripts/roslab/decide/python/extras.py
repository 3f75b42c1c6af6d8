"""The extras and groups with which a page has the repository's own projects installed: ``pip install -e ".[sim]"``."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Sequence, Set

from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.evidence.python.manager_lines import EVERY, GROUP
from roslab.evidence.python_project import PythonProject
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_WRITTEN = pattern(r"([^\[\]]*)\[([\w\s,./*-]+)\]")
_DEVELOPERS = pattern(
    r"(?:^|[-_./])(?:dev\w*|tests?|testing|docs?|documentation|lint\w*|format\w*|style|build|release|ci|typing)(?:[-_.]|$)"
)
"""Extras for those who work on the project itself."""
_OF_MACHINES = pattern(
    r"(?:^|[-_.])(?:tpu|rocm|amd|mac(?:os\w*)?|osx|darwin|metal|mps|win(?:dows)?|jetson|colab|hpc)(?:[-_.\d]|$)"
)
"""Extras for another machine than that of the image."""


def extras(
    evidence: Evidence, projects: Sequence[PythonProject], files: Iterable[RequirementFile]
) -> tuple[Requirement, ...]:
    """Return what the extras of the first line that installs each project with any ask for, each package once.

    Lines without extras may come before it: it adds to them. A later line with other extras is a variant. Those for
    developers are left out, unless no line installs it without them: the author means all readers.
    """
    lines = [each for each in evidence.prose_pip if each.file.count("/") <= 1 and not DEVELOPMENT.search(each.file)]
    lines += [each for file in files for each in file.requirements]
    elsewhere = {(each.file, each.line) for each in lines if each.vcs}  # it is the folder of a clone
    folders = {project.folder for project in projects}
    ways: dict[str, list[tuple[str, ...]]] = {}
    for asked in lines:
        folder = _folder(asked, folders) if asked.role == "project" else None
        match = _WRITTEN.fullmatch(asked.written)
        if folder is not None and (asked.file, asked.line) not in elsewhere:
            named = tuple(name.strip() for name in match[2].split(",")) if match else ()
            if not named or not all(_OF_MACHINES.search(name.lower()) for name in named):
                ways.setdefault(folder, []).append(named)
    found: dict[str, Requirement] = {}
    for project in projects:
        lines_of = ways.get(project.folder, [()])
        first = next((names for names in lines_of if not all(map(for_developers, names))), lines_of[0])
        for asked in _of(project, first, every=set(lines_of) == {first}):
            found.setdefault(asked.key, asked)
    return tuple(found.values())


def of_pages(
    evidence: Evidence, files: Iterable[RequirementFile], projects: Iterable[PythonProject]
) -> tuple[Requirement, ...]:
    """Return what the page at the root installs with extras and a list or project without them: ``jax[cuda12]``.

    These are for any machine, the page adds what one with a GPU needs, the first time it names the package. Another
    version than theirs is for another time.
    """
    declared = [each for project in projects for each in project.requirements if each.role in {"", "source"}]
    declared += [each for file in files for each in file.requirements]
    listed = {each.key: each for each in declared if each.name and each.package}
    found: dict[str, Requirement] = {}
    for asked in evidence.prose_pip:
        before = listed.get(asked.key)
        if "/" in asked.file or not asked.extras or not before or before.url or asked.url:
            continue
        same = not asked.limited or asked.specifier == before.specifier
        if same and not set(asked.extras) <= set(before.extras) and not _developers(asked):
            written = f"{asked.name}[{','.join(asked.extras)}]{before.specifier}"
            found.setdefault(asked.key, replace(asked, written=written, specifier=before.specifier))
    return tuple(found.values())


def beside_lists(guessed: Iterable[Requirement], files: Iterable[RequirementFile]) -> tuple[Requirement, ...]:
    """Return those of ``guessed`` that are packages of these files, which name them without the extras."""
    listed = {each.key for file in files for each in file.requirements if each.name}
    return tuple(each for each in guessed if each.extras and not each.url and each.key in listed)


def _developers(asked: Requirement) -> bool:
    return all(map(for_developers, asked.extras))


def for_developers(extra: str) -> bool:
    """Tell whether an extra is for those who work on the project itself: its tests, its documentation."""
    return bool(_DEVELOPERS.search(extra.lower()))


def _folder(asked: Requirement, known: Set[str]) -> str | None:
    """Return the project's folder that a line installs; ``cd REPOSITORY`` before it goes to the root."""
    written = posixpath.normpath(asked.written.partition("[")[0] or ".")
    parts = [part for part in written.split("/") if part not in {"", ".", "..", "~"}]
    tails = ["/".join(parts[start:]) for start in range(len(parts))]
    found = next((tail for tail in tails if tail in known), None)
    return found if found or len(parts) > 1 else ""


def _of(project: PythonProject, names: Iterable[str], *, every: bool) -> list[Requirement]:
    """Return what extras of a project ask for; one may name others of the same project: ``all = ["demo[sim,gui]"]``.

    ``every``: those for developers, too, if they are named; not groups.
    """
    own = canonicalize_name(project.name) if project.name else ""
    found: list[Requirement] = []
    known = [each.group for each in project.requirements if each.role == "extra" and not each.group.startswith(GROUP)]
    meant = {name for name in names if every and name in known}
    names = [each for name in names for each in (known if name == EVERY else (name,))]
    pending = [canonicalize_name(name) for name in names if name in meant or not for_developers(name)]
    done: set[str] = set()
    while pending:
        name = pending.pop(0)
        done.add(name)
        for asked in project.requirements:
            if asked.role != "extra" or canonicalize_name(asked.group) != name:
                continue
            if asked.key == own:
                more = map(canonicalize_name, asked.extras)
                pending += [each for each in more if each not in done and not for_developers(each)]
            else:
                found.append(replace(asked, role="", group=""))
    return found
