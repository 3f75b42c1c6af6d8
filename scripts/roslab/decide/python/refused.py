"""Requirements that pip would refuse: what is installed instead, and how the rest is installed."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.python.manifests import with_includes
from roslab.decide.python.pythons import ANY
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, PythonProject, RequirementFile
from roslab.knowledge.not_on_index import NotOnIndex, not_on_index
from roslab.values.dataclass import dataclass, replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import FREE, Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class Repaired:
    """Requirements to install one by one in place of files and of projects' dependencies."""

    requirements: tuple[Requirement, ...] = ()
    files: frozenset[str] = frozenset()
    """Requirement files that are not installed as they stand."""
    alone: tuple[str, ...] = ()
    """Folders of projects that pip installs without their dependencies."""
    warnings: tuple[Warning_, ...] = ()


def refused(asked: Requirement) -> NotOnIndex | None:
    """Return the table row of a name that pip cannot find or install; ``None`` for all others."""
    row = not_on_index().get(asked.key)
    if row is None or asked.url or not ANY.may(asked):
        return None
    same = bool(row.instead) and asked.key.startswith(canonicalize_name(row.instead))
    return None if asked.specifier and same else row


def right(requirements: Iterable[Requirement]) -> Iterator[Requirement]:
    """Yield what pip can install, with wrong names corrected."""
    for asked in requirements:
        row = refused(asked)
        if row is None:
            yield asked
        elif row.instead:
            yield replace(asked, name=row.instead, written=row.instead, specifier=FREE)


def repair(
    evidence: Evidence, files: Iterable[RequirementFile], projects: Iterable[PythonProject], own: Iterable[str]
) -> Repaired:
    """Return how to install what is declared if pip would refuse some of its lines; ``own`` are names in the tree.

    So it does with a folder (``-e .``): files are installed before the source is there, and pip looks for a folder
    from where it is started (https://pip.pypa.io/en/stable/reference/requirements-file-format/, read 2026-11-23).
    """
    names = set(own)
    kept: list[Requirement] = []
    broken: set[str] = set()
    alone: list[str] = []
    warnings: list[Warning_] = []
    for file in files:
        found = [asked for each in with_includes(evidence, [file]) for asked in each.requirements]
        spelled = [asked for asked in found if asked.role == "repaired"]
        missing = [asked for asked in found if refused(asked)]
        if not (spelled or missing or any(asked.role == "project" for asked in found)):
            continue
        broken.add(file.file)
        kept += _kept((asked for asked in found if asked.role != "project"), names)
        text = f"pip would refuse this line; the packages of {file.file} are installed one by one"
        warnings += [warn(text, asked) for asked in spelled[:1]]
        warnings += [_warning(asked) for asked in missing if asked.key not in names]
    for project in projects:
        found = [asked for asked in project.requirements if asked.role in {"", "source", "member"}]
        missing = [asked for asked in found if refused(asked) and asked.key not in names]
        if missing or any(asked.role for asked in found):  # or pip would look for it in the wrong place
            alone.append(project.folder or ".")
            kept += _kept(found, names)
            warnings += [_warning(asked) for asked in missing]
    return Repaired(
        requirements=tuple(kept),
        files=frozenset(broken),
        alone=tuple(alone),
        warnings=tuple(dict.fromkeys(warnings)),
    )


def untold(guessed: Iterable[Requirement], brought: Collection[str]) -> Iterator[Warning_]:
    """Yield a warning for each guess that pip cannot install and that nothing else, such as conda, has ``brought``."""
    for asked in guessed:
        if (row := refused(asked)) and not row.instead and asked.key not in brought and asked.origin != "import":
            yield _warning(asked)


def _kept(found: Iterable[Requirement], own: set[str]) -> list[Requirement]:
    """Return the requirements without those for packages of the tree itself."""
    return [asked for asked in right(found) if asked.key not in own]


def _warning(asked: Requirement) -> Warning_:
    row = not_on_index()[asked.key]
    without = f"the image is built without it, install it with `custom` or `pip` in roslab.yaml ({row.source})"
    does = f"{row.instead} is installed" if row.instead else without
    return warn(f"pip cannot install {asked.key}: {row.why}; {does}", asked)
