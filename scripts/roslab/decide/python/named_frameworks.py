"""Frameworks that a page installs in one version: they come first, and nothing that follows replaces them."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.cuda.local import cuda_of
from roslab.decide.decision import Choice, Reason
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.knowledge.frameworks import framework, framework_on_cuda, released_together
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

_WHY = "a page names this version: what is installed after it fits it"


@dataclass(frozen=True, kw_only=True, slots=True)
class Named:
    """Guesses that count as declared, and the limits that they are for all others."""

    first: tuple[Requirement, ...] = ()
    limits: tuple[Requirement, ...] = ()


def named_frameworks(guessed: Iterable[Requirement], python: str | None) -> Choice[Named]:
    """Return the frameworks among the guesses that a page pins, and what it pins beside them.

    Only a release that the tables know for this ``python``: a line for another one must not stop the build.
    """
    said = [each for each in guessed if each.release and each.origin == "prose" and not each.url]
    leading = [each for each in said if framework_on_cuda(each.key) and _has_wheel(each, python)]
    beside = {name for each in leading for name in released_together().get(framework_on_cuda(each.key) or "", ())}
    files = {each.file for each in leading}
    first = (*leading, *(each for each in said if each.key in beside and each not in leading and each.file in files))
    limits = {stated(f"{each.key}{each.specifier}"): each for each in first}
    return Choice(
        answer=Named(first=first, limits=tuple(limits)),
        reasons=tuple(_because(limit, each) for limit, each in limits.items()),
    )


def _has_wheel(asked: Requirement, python: str | None) -> bool:
    release = asked.release or ""
    row = framework(asked.key, release)
    if row is None or python is None or not row.runs_with(python):
        return False
    local = cuda_of(release)
    return not Version(release).local or (local or "") in row.cuda or Version(release).local == "cpu"


def _because(limit: Requirement, asked: Requirement) -> Reason:
    return because("dependencies", limit.written, _WHY, asked, weight=Weight.BOUND)
