"""Extensions whose C++ is written for an older release of a package than the newest ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.cuda.toolkit import by_script
from roslab.decide.decision import Choice, Warning_
from roslab.decide.python.manifests import projects
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.old_code import OldCode
from roslab.evidence.python_project import PythonProject
from roslab.evidence.removed_name import Removed
from roslab.knowledge.frameworks import newest_framework
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def with_bounds(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence with an upper bound for what newer releases of a package do not compile.

    No bound from what a macro brings back.
    """
    if not evidence.old_code:
        return evidence
    uses = [use for use in _compiled(evidence, projects(evidence, kind, None)) if not use.define]
    lowest: dict[str, OldCode] = {}
    for use in sorted(uses, key=lambda use: Version(use.below)):
        lowest.setdefault(use.package, use)
    known = {bound.bound.key for bound in evidence.bounds}
    added = (
        Removed(bound=stated(f"{name}<{use.below}"), what=use.what, file=use.file, line=use.line)
        for name, use in lowest.items()
        if name not in known
    )
    return replace(evidence, bounds=(*evidence.bounds, *added))


def decide_defines(
    evidence: Evidence,
    chosen: Iterable[PythonProject],
    asked: Iterable[Requirement],
    python: str | None,
    aged: str | None = None,
) -> Choice[tuple[str, ...]]:
    """Return the macros with which old code compiles, where nothing else keeps it from the releases that are installed.

    ``asked`` are the packages and their limits. ``aged`` is the torch that the code is for, where it is replaced by a
    newer one: what a submodule compiles that is not checked out is as old, and nobody can read it here.
    """
    asked = tuple(asked)
    found = [*_compiled(evidence, chosen), *(_unread(evidence, aged) if aged else ())]
    uses = [use for use in found if _too_new(use, asked, evidence.pip_day, python)]
    if any(not use.define for use in uses):
        return Choice(answer=())
    first = {use.define: use for use in reversed(uses)}
    return Choice(answer=tuple(sorted(first)), warnings=tuple(_warning(use) for use in first.values()))


def _compiled(evidence: Evidence, chosen: Iterable[PythonProject]) -> Iterator[OldCode]:
    """Yield the uses in what pip installs, or in what a script of a page compiles."""
    installed = {project.file for project in chosen}
    scripted = bool(by_script(evidence))
    for use in evidence.old_code:
        if use.script in installed or (scripted and not places.aside(use.script)):
            yield use


def _unread(evidence: Evidence, aged: str) -> Iterator[OldCode]:
    """Yield all that macros bring back of what a torch still had, for the first submodule that is not checked out."""
    from roslab.knowledge.extension_code import dropped  # noqa: PLC0415 - few trees compile for Python

    absent = next((git for git in evidence.sources if git.kind == "submodule" and git.absent), None)
    for row in dropped() if absent else ():
        if absent and row.package == "torch" and row.define and Version(aged) < Version(row.below):
            yield OldCode(
                script="",
                package="torch",
                below=row.below,
                define=row.define,
                what=row.what,
                file=absent.file,
                line=absent.line,
            )


def _too_new(use: OldCode, asked: tuple[Requirement, ...], day: str | None, python: str | None) -> bool:
    """Tell whether the release that is installed is one that has dropped it."""
    said = [each for each in asked if each.key == use.package and not each.url]
    release = next((each.release for each in said if each.release), None)
    if release:
        return Version(release) >= Version(use.below)
    if not said or any(each.below and Version(each.below) <= Version(use.below) for each in said):
        return False
    newest = newest_framework(use.package, day, python)
    return newest is not None and Version(newest.first) >= Version(use.below)


def _warning(use: OldCode) -> Warning_:
    has = "the C++ code has" if use.script else "the C++ code of a submodule that is not checked out may have"
    why = f"{has} {use.what}, which {use.package} dropped with {use.below}"
    return warn(f"{why}; it is compiled with -D{use.define}", use)
