"""Libraries that packages of pip need and do not bring: the image has them before pip builds the package."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because, warn
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.native_parts import Native, bringing, natives, series_of
from roslab.values.dataclass import dataclass, replace
from roslab.values.native_part import NativePart
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import version_of


@dataclass(frozen=True, kw_only=True, slots=True)
class NativeParts:
    """What the image gets beside the packages of pip."""

    parts: tuple[NativePart, ...] = ()
    modules: tuple[str, ...] = ()
    """Modules that compile themselves when they are first imported."""
    brought: tuple[Requirement, ...] = ()
    """Packages that come with others, as ``brought`` tells."""
    bounds: tuple[Requirement, ...] = ()
    """pip constraints: newer versions do not compile these modules."""


def brought(asked: Iterable[Requirement], day: str | None) -> tuple[Requirement, ...]:
    """Return what packages that are asked for have pip install with them, and these in turn, as far as a table knows.

    ``day``: pip's. What is asked for by itself is not returned.
    """
    pending = [each for each in asked if each.package and each.role != "conda"]
    named = {each.key: each for each in pending}
    limited = {each.key: each for each in reversed(pending) if each.limited}
    found: dict[str, Requirement] = {}
    while pending:
        each = pending.pop(0)
        for other in _brought_by(each, limited.get(each.key, each), day):
            before = named.setdefault(other.key, other)
            if before is other:
                found[other.key] = other
                pending.append(other)
            elif not set(other.extras) <= set(before.extras):  # the author's release, with these extras too
                named[other.key] = replace(before, extras=(*before.extras, *other.extras))
                pending.append(named[other.key])
    return tuple(found.values())


def _brought_by(asked: Requirement, limited: Requirement, day: str | None) -> Iterator[Requirement]:
    """Yield what a package brings in the release that is taken of it, one of each series of its rows."""
    key = asked.key
    rows = [row for row in bringing() if row.pip == key]
    for part in dict.fromkeys(row.part for row in rows):
        row = series_of(limited, day, (each for each in rows if each.part == part))
        if not row or not row.brings or (row.of_index and asked.url):
            continue
        if not row.extras or not set(row.extras).isdisjoint(asked.extras):
            yield stated(row.brings, "table", asked.file, asked.line)


def decide_native_parts(
    installed: Iterable[Requirement],
    guessed: Sequence[Requirement],
    projects: Iterable[PythonProject],
    day: str | None,
) -> Choice[NativeParts]:
    """Return the libraries of all packages in ``installed`` and of the tree's own ``projects``, as of pip's ``day``.

    Some of them are only ``guessed``: pip installs them last, where they are not there. conda's packages bring theirs.
    The first of several releases of a package counts, before all that of a copy in the tree.
    """
    declared = [each for each in installed if each not in guessed]
    of_declared = brought(declared, day)
    of_guessed = brought((*declared, *of_declared, *guessed), day)
    own = [_own(each.name, each) for each in projects if each.name]
    asked: dict[str, Requirement] = {}
    for each in (*own, *declared, *of_declared, *guessed, *of_guessed):
        if each.package and each.role != "conda":
            asked.setdefault(each.key, each)
    sure = {each.key for each in (*declared, *of_declared, *own)}
    names = {row.pip for row in natives()}
    rows = [(each, series_of(each, day, natives())) for each in asked.values() if each.key in names]
    found = [(each, row) for each, row in rows if row]
    bounds = (stated(row.bound) for _, row in found if row.bound)
    return Choice(
        answer=NativeParts(
            parts=tuple(_part(row, guessed=each.key not in sure) for each, row in found if row.part),
            brought=(*of_declared, *of_guessed),
            modules=tuple(dict.fromkeys(row.module for _, row in found if row.module)),
            bounds=tuple({each.key: each for each in bounds if not _held(each, asked)}.values()),
        ),
        reasons=tuple(_reasons(found)),
        warnings=tuple(_lacking(each) for each, row in rows if not row),
    )


def _held(bound: Requirement, asked: dict[str, Requirement]) -> bool:
    """Tell whether the author limits a package by himself, or wants a newer one than a bound leaves."""
    author = asked.get(bound.key)
    return author is not None and (author.limited or author.at_least is not None)


def _part(row: Native, *, guessed: bool) -> NativePart:
    return NativePart(
        name=row.part,
        package=row.pip,
        folder=row.folder,
        archive=row.archive,
        unpacks=row.unpacks,
        key=row.key,
        variables=tuple(_placed(row)),
        guessed=guessed,
    )


def _placed(row: Native) -> Iterator[tuple[str, str]]:
    """Yield the variables, each with its own path, or those of the folder and of the key in this order."""
    usual = iter((row.folder, *(row.key or ())[:1]))
    for variable in row.variables:
        name, _, path = variable.partition("=")
        place = next(usual, row.folder)
        yield name, path or place


def _own(name: str, project: PythonProject) -> Requirement:
    """Return a project of the tree as a requirement: a copy of a package is of the release that it says."""
    release = f"=={project.version}" if project.version and version_of(project.version) else ""
    return stated(f"{name}{release}", "build", project.file, project.line)


def _reasons(found: Iterable[tuple[Requirement, Native]]) -> Iterator[Reason]:
    for asked, row in found:
        if row.part:
            does = "is compiled against" if row.module else "loads"
            why = f"{asked.written} {does} it and does not bring it"
            yield because("dependencies", row.part, why, asked if asked.file else None, weight=Weight.MANIFEST)


def _lacking(asked: Requirement) -> Warning_:
    message = (
        f"{asked.written} needs a native library that no row of the tables names, so that the image lacks it: "
        f"take a newer release of {asked.key}"
    )
    return warn(message, asked if asked.file else None)
