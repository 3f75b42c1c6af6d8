"""Upper bounds of Python packages for code that uses names they have removed since."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Choice, Reason
from roslab.decide.python.weights import PackageWeight
from roslab.decide.reasons import because, warn
from roslab.evidence.removed_name import Removed
from roslab.knowledge.removals import removals
from roslab.knowledge.table import rows
from roslab.values.requirement import Requirement
from roslab.values.version import Version, version_of

Constraints = tuple[Requirement, ...]


def decide_bounds(uses: Iterable[Removed], asked: Iterable[Requirement]) -> Choice[Constraints]:
    """Return constraints for the packages in ``asked`` that have no upper bound from the author.

    None that the author's own lower bound excludes: pip would find no version at all. None of NumPy either where a
    release is asked for that needs a newer one; then that is told.
    """
    asked = tuple(asked)
    limited = {each.key: each.limited for each in asked if each.name}
    chosen = [use for use in uses if limited.get(use.bound.key) is False and not excluded(use.bound, asked)]
    newer = {use: pin for use in chosen if use.bound.key == "numpy" and (pin := needing_numpy(asked, use.bound.below))}
    told = [
        warn(
            f"the code uses {use.what}, which no NumPy has from {use.bound.below} on, and {pin.written} needs one", use
        )
        for use, pin in list(newer.items())[:1]
    ]
    chosen = [use for use in chosen if use not in newer]
    if not chosen:
        return Choice(answer=(), reasons=(), warnings=tuple(told))
    beside = {removal.bound: removal.beside for removal in removals()}
    bounds: dict[Requirement, Reason] = {}
    for use in chosen:
        why = f"the code uses {use.what}, which newer versions no longer have"
        bounds[use.bound] = because("dependencies", use.bound.written, why, use, weight=PackageWeight.BOUND)
        needed = beside.get(use.bound)
        if needed and not limited.get(needed.key) and not excluded(needed, asked):
            why = f"{use.bound.written} was compiled against it; {why}"
            bounds.setdefault(needed, because("dependencies", needed.written, why, use, weight=PackageWeight.BOUND))
    # One bound per package: the lower of two is the one that the code itself needs
    own = {use.bound for use in chosen}
    names = {bound.key for bound in own}
    kept = {bound: why for bound, why in bounds.items() if bound in own or bound.key not in names}
    return Choice(answer=tuple(kept), reasons=tuple(kept.values()), warnings=tuple(told))


def excluded(bound: Requirement, asked: Iterable[Requirement]) -> bool:
    """Tell whether a package is asked for in no version that a bound leaves: pip would find none."""
    return any(_exclusive(bound, each) for each in asked)


def _exclusive(one: Requirement, other: Requirement) -> bool:
    """Tell whether two requirements of one package leave it no release.

    The versions that they name and their neighbours are tried.
    """
    if one.key != other.key or one.url or other.url or one.marker or other.marker:
        return False
    return not any(
        one.specifier.contains(version, prereleases=True) and other.specifier.contains(version, prereleases=True)
        for version in {*_tried(one), *_tried(other)}
    )


def _tried(asked: Requirement) -> Iterator[str]:
    """Yield the versions that a requirement names, one directly above each and one directly below."""
    yield "0"
    for part in asked.specifier:
        named = part.version.removesuffix(".*")
        yield named
        if found := version_of(named):
            numbers = list(found.release)
            yield ".".join(map(str, (*numbers, 1)))
            while numbers and not numbers[-1]:
                numbers.pop()
            if numbers:
                yield ".".join(map(str, (*numbers[:-1], numbers[-1] - 1, 99999)))


def needing_numpy(asked: Iterable[Requirement], below: str | None) -> Requirement | None:
    """Return what is asked for in releases that all need a NumPy which is not ``below`` that one."""
    if below is None:
        return None
    known = [each for each in rows("needs_numpy") if _reaches(each["numpy"], below)]
    for each in asked:
        oldest = each.release or each.at_least
        if any(each.key == one["pip"] and _reaches(oldest, one["first"]) for one in known):
            return each
    return None


def _reaches(release: str | None, first: str) -> bool:
    return release is not None and Version(release) >= Version(first)
