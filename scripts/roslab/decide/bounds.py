"""How old a Python package must be for code that uses what it has since removed."""

from __future__ import annotations

from collections.abc import Iterable

from packaging.requirements import InvalidRequirement, Requirement
from packaging.utils import canonicalize_name

from roslab.decide.decision import Reason
from roslab.evidence.facts import Dependency


def decide_bounds(uses: Iterable[Dependency], lines: Iterable[str]) -> tuple[tuple[str, ...], tuple[Reason, ...]]:
    """Return the constraints for packages that are installed (``lines``) without an upper bound of the author's own."""
    limited = {canonicalize_name(r.name): _limited(r) for line in lines if (r := _requirement(line))}
    chosen = [use for use in uses if limited.get(canonicalize_name(Requirement(use.name).name)) is False]
    reasons = tuple(
        Reason(
            question="dependencies",
            answer=use.name,
            reason=f"the code uses {use.role}, which newer versions no longer have",
            file=use.file,
            line=use.line,
            weight=30,
        )
        for use in chosen
    )
    return tuple(use.name for use in chosen), reasons


def _requirement(line: str) -> Requirement | None:
    try:
        return Requirement(line)
    except InvalidRequirement:
        return None


def _limited(requirement: Requirement) -> bool:
    """Tell whether the author's own specifier keeps the newest version out, or names where it comes from."""
    return bool(requirement.url) or any(s.operator in {"==", "===", "<", "<=", "~="} for s in requirement.specifier)
