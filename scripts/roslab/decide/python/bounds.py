"""How old a Python package must be for code that uses what it has since removed."""

from __future__ import annotations

from collections.abc import Iterable

from packaging.requirements import InvalidRequirement, Requirement
from packaging.utils import canonicalize_name

from roslab.decide.decision import Reason
from roslab.evidence.facts import Dependency
from roslab.knowledge.removals import removals


def decide_bounds(uses: Iterable[Dependency], lines: Iterable[str]) -> tuple[tuple[str, ...], tuple[Reason, ...]]:
    """Return the constraints for packages that are installed (``lines``) without an upper bound of the author's own."""
    limited = {canonicalize_name(r.name): _limited(r) for line in lines if (r := _requirement(line))}
    chosen = [use for use in uses if limited.get(canonicalize_name(Requirement(use.name).name)) is False]
    beside = {removal.bound: removal.beside for removal in removals()}
    bounds: dict[str, Reason] = {}
    for use in chosen:
        why = f"the code uses {use.role}, which newer versions no longer have"
        bounds[use.name] = _reason(use, use.name, why)
        needed = beside.get(use.name)
        if needed and not limited.get(canonicalize_name(needed.partition("<")[0])):
            bounds.setdefault(needed, _reason(use, needed, f"{use.name} was compiled against it; {why}"))
    # One bound a package: of two, the lower is the one that the code itself asks for
    asked = {Requirement(use.name).name for use in chosen}
    kept = {b: r for b, r in bounds.items() if b in {use.name for use in chosen} or Requirement(b).name not in asked}
    return tuple(kept), tuple(kept.values())


def _reason(use: Dependency, answer: str, why: str) -> Reason:
    return Reason(question="dependencies", answer=answer, reason=why, file=use.file, line=use.line, weight=30)


def _requirement(line: str) -> Requirement | None:
    try:
        return Requirement(line)
    except InvalidRequirement:
        return None


def _limited(requirement: Requirement) -> bool:
    """Tell whether the author's own specifier keeps the newest version out, or names where it comes from."""
    return bool(requirement.url) or any(s.operator in {"==", "===", "<", "<=", "~="} for s in requirement.specifier)
