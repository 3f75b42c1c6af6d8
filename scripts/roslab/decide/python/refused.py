"""Requirements that pip would refuse: what is installed instead, and how the rest of their file or project still is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from roslab.decide.decision import Warning_
from roslab.decide.python.packages import with_includes
from roslab.decide.python.pins import name_of
from roslab.evidence.facts import Dependency, Evidence, PythonProject, RequirementFile
from roslab.knowledge.not_on_index import NotOnIndex, not_on_index


@dataclass(frozen=True, kw_only=True, slots=True)
class Repaired:
    """Lines to install one by one in the place of files and of projects' dependencies."""

    lines: tuple[str, ...] = ()
    files: frozenset[str] = frozenset()
    """Requirement files that are not installed as they stand."""
    alone: tuple[str, ...] = ()
    """Folders of projects that pip installs without their dependencies."""
    warnings: tuple[Warning_, ...] = ()


def refused(line: str) -> NotOnIndex | None:
    """Return the row of a name that pip does not find, or finds only to fail; ``None`` for all others."""
    row = not_on_index().get(name_of(line))
    if row is None or "@" in line or line.startswith(("git+", "http")):
        return None
    versioned = any(sign in line for sign in "=<>~")
    return None if versioned and row.instead and name_of(line).startswith(name_of(row.instead)) else row


def right(lines: Iterable[str]) -> Iterator[str]:
    """Yield the lines that pip can install, with the right name in the place of a wrong one."""
    for line in lines:
        row = refused(line)
        if row is None or row.instead:
            yield row.instead if row else line


def repair(
    evidence: Evidence, files: Iterable[RequirementFile], projects: Iterable[PythonProject], own: Iterable[str]
) -> Repaired:
    """Return how what is declared is installed although pip would refuse a line of it; ``own`` are the tree's names."""
    names = set(own)
    lines: list[str] = []
    broken: set[str] = set()
    alone: list[str] = []
    warnings: list[Warning_] = []
    for file in files:
        found = [d for each in with_includes(evidence, [file]) for d in each.dependencies]
        spelled = [d for d in found if d.role == "repaired"]
        missing = [d for d in found if refused(d.name)]
        if not (spelled or missing):
            continue
        broken.add(file.file)
        lines += _kept((d for d in found if d.role != "project"), names)
        text = f"pip would refuse this line; the packages of {file.file} are installed one by one"
        warnings += [Warning_(message=text, file=d.file, line=d.line) for d in spelled[:1]]
        warnings += [_warning(d) for d in missing if name_of(d.name) not in names]
    for project in projects:
        found = [d for d in project.dependencies if d.role in {"", "source", "member"}]
        missing = [d for d in found if refused(d.name) and name_of(d.name) not in names]
        if missing or any(d.role for d in found):  # or where pip would look for it is not where its author has it
            alone.append(project.folder or ".")
            lines += _kept(found, names)
            warnings += [_warning(d) for d in missing]
    return Repaired(
        lines=tuple(lines), files=frozenset(broken), alone=tuple(alone), warnings=tuple(dict.fromkeys(warnings))
    )


def _kept(found: Iterable[Dependency], own: set[str]) -> list[str]:
    """Return the lines for pip, with their markers and without the tree's own names."""
    lines = (d.name + (f"; {d.condition}" if d.condition else "") for d in found)
    return [line for line in right(lines) if name_of(line) not in own]


def _warning(dependency: Dependency) -> Warning_:
    name, row = name_of(dependency.name), not_on_index()[name_of(dependency.name)]
    without = f"the image is built without it, install it by `custom` or `pip` in roslab.yaml ({row.source})"
    does = f"{row.instead} is installed" if row.instead else without
    return Warning_(message=f"pip cannot install {name}: {row.why}; {does}", file=dependency.file, line=dependency.line)
