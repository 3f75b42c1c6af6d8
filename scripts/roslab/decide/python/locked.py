"""Releases of a lock, for what the manifests leave free: the days on which their authors wrote them are theirs."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from roslab.decide.decision import Choice
from roslab.decide.python.beside_lock import differs, needed
from roslab.decide.python.bounds import Constraints
from roslab.decide.python.framework_pins import WHY_LOCKED
from roslab.decide.python.packages import Chosen
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.evidence.locked import Locked
from roslab.knowledge.frameworks import released_together
from roslab.knowledge.tools import INSTALLERS
from roslab.values.interpreter import Interpreter
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version

_CPYTHON = pattern(r"cp3(\d{1,2})")


def locked_releases(
    locked: Iterable[Locked],
    asked: Iterable[Requirement],
    taken: Iterable[Requirement],
    python: str | None,
    guessed: Iterable[Requirement] = (),
) -> Choice[Constraints]:
    """Return constraints for those of ``asked`` that no manifest pins, from a lock, for an image with this ``python``.

    So for what these need, directly or not, and for what is ``guessed`` in any release: click breaks an older typer.

    Not for what ``taken`` limits already or another index has, nor, unless it is the lock's own release, for what needs
    that: a lock fits together as a whole only. Nor for what some line takes from an address, whose release is its own,
    and what that needs. A framework and what is released with it count as one. Left free is also what has wheels, but
    none for this Python, and pip's own tools, of which each package that is compiled asks for others.
    """
    if python is None:
        return Choice(answer=())
    by_name: dict[str, list[Locked]] = {}
    here = Interpreter(pythons=(python,), platforms=("linux/amd64",))
    for each in locked:
        if here.may(each.requirement):
            by_name.setdefault(each.requirement.key, []).append(each)
    one = {name: same[0] for name, same in by_name.items() if len({s.requirement.release for s in same}) == 1}
    named = [each for each in asked if each.name]
    packages = [each for each in named if each.package and here.may(each)]
    wanted = dict.fromkeys(each.key for each in named if each.package)
    apart = {each.key for each in named if each.url}
    apart |= {need for name in apart for each in by_name.get(name, ()) for need in each.needs}
    taken = tuple(taken)
    other = {each.key for each in taken if not _agrees(each, one)}
    other |= {each.key for each in packages if differs(each, one)}
    other |= {name for name, same in by_name.items() if any(each.elsewhere for each in same)}
    other = _needing(_families(other), by_name) | {*INSTALLERS}
    pinned = {each.key for each in packages if each.release}
    free = {*other, *apart, *(each.key for each in taken)}
    imported = {each.key for each in guessed if each.name and (not each.limited or _of_an_extra(each, one))}
    beneath = _beneath({*wanted}, imported, free, by_name)
    kept = [
        one[key].requirement
        for key in (*wanted, *sorted(beneath - {*wanted}))
        if key in one and key not in free | pinned and _has_wheel(one[key], python)
    ]
    lines = tuple(stated(each.written.partition("+")[0], "lock", each.file, each.line) for each in kept)
    reasons = (because("dependencies", each.written, WHY_LOCKED, each, weight=Weight.BOUND) for each in lines)
    return Choice(answer=lines, reasons=tuple(reasons))


def of_what_is_installed(locked: Collection[Locked], chosen: Chosen) -> bool:
    """Tell whether the project beside a lock is installed, or, at the root, what it declares."""
    folder = next((each.requirement.file.rpartition("/")[0] for each in locked), "")
    return (not folder and bool(chosen.declared)) or any(project.folder == folder for project in chosen.projects)


def _of_an_extra(guess: Requirement, one: Mapping[str, Locked]) -> bool:
    """Tell whether an extra of the project limits a guess to what the lock has, too."""
    return bool(guess.group and guess.package) and guess.key in one and not differs(guess, one)


def _agrees(taken: Requirement, one: Mapping[str, Locked]) -> bool:
    """Tell whether a limit is the very release that the lock has, whichever build of it."""
    locked = one[taken.key].requirement.release if taken.key in one else None
    releases = {each.version.partition("+")[0] for each in taken.specifier if each.operator == "=="}
    return locked is not None and locked.partition("+")[0] in releases


def _families(names: Collection[str]) -> set[str]:
    """Return the names, of a framework with all that is released together with it."""
    together = ({name, *beside} for name, beside in released_together().items())
    return {*names}.union(*(family for family in together if family & {*names}))


def _needing(names: set[str], by_name: Mapping[str, Iterable[Locked]]) -> set[str]:
    """Return the names and all that needs one of them, directly or not."""
    while more := {
        name for name, same in by_name.items() if name not in names and any(names & {*s.needs} for s in same)
    }:
        names = names | more
    return names


def _beneath(wanted: set[str], more: set[str], free: set[str], by_name: Mapping[str, Iterable[Locked]]) -> set[str]:
    """Return what the wanted names and ``more`` need, without what a ``free`` one may need in another release.

    Nothing where a manifest asks for what the lock does not know: the lock is older, or of another part.
    """
    return needed((wanted | more) - free, by_name) - needed(free, by_name) if wanted <= {*by_name, *free} else set()


def _has_wheel(each: Locked, python: str) -> bool:
    """Tell whether a release has a wheel for this Python on Linux, or none at all: then pip compiles it."""
    return not each.wheels or any(_fits(name, python) for name in each.wheels)


def _fits(name: str, python: str) -> bool:
    from roslab.values.wheel import wheel_of  # noqa: PLC0415 - few trees have a lock

    wheel = wheel_of(name)
    minor = Version(python).minor
    for tag in wheel.tags if wheel else ():
        built = _CPYTHON.fullmatch(tag.interpreter)
        known = tag.interpreter == "py3" or (built is not None and int(built[1]) == minor)
        known = known or (built is not None and tag.abi == "abi3" and int(built[1]) <= minor)
        if known and (tag.platform == "any" or ("linux" in tag.platform and tag.platform.endswith("x86_64"))):
            return True
    return False
