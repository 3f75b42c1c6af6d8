"""Packages that do not compile and that nothing needs: the build goes on without them, by ``skip_packages``."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping

from roslab.config.addition import Entry, has
from roslab.decide.programs import owner
from roslab.decide.ros.workspace import packages_of
from roslab.decide.system.left_out import SKIP, needing
from roslab.decide.system.required import asking
from roslab.explain.answer import Answer, Explanation
from roslab.knowledge.repairs import SKIP as KEY
from roslab.plan.ros_build import WORKSPACE
from roslab.repair import generated
from roslab.repair.alone import alone
from roslab.repair.asked import asked
from roslab.repair.change import Asked, Change, Given
from roslab.repair.needs import Needs, needs
from roslab.repair.said import by_machine, said
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_SHARE = 2
"""Where a shell is started, one of so many packages may be left out: of more, something else is wrong."""
_LIBRARY = pattern(r"^roslab: (\S{1,100}) of [^\n]{1,600} cannot be (?:cloned|compiled): the build stops", re.MULTILINE)
"""What the build says of a library that it builds from source, and in which it stopped."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Left:
    """What is left out, or why nothing is."""

    changes: tuple[Change, ...] = ()
    why: str = ""


def left_out(answer: Answer, given: Given) -> Left:
    """Return the packages in which a build stopped and which are left out of the next one, as changes of roslab.yaml.

    Of a plain CMake project it is all but the default command's program.
    Each step that failed must have stopped in packages of the repository alone, by no fault of the network or the
    machine, and the default command, its launch files and the tests must need none of them, nor of those that cannot be
    built without them. Where a shell is started, nothing that remains may need them. So it is with the packages whose
    CMake asks for a library from source in which the build stopped.
    """
    if program := alone(answer, given):
        return Left(changes=program)
    build = given.plan.workspace.ros
    if build is None or build.tool not in SKIP or given.plan.author_dockerfile or given.config.generation != "today":
        return Left()
    failed: dict[str, Explanation] = {}
    for found in answer.explanations:
        names = _packages(found, given) or _asking(found, given)
        if not names or by_machine(found):
            return Left()
        failed |= {name: found for name in names if name not in failed}
    needed = needs(given) if failed else None
    if needed is None or any(has(given.config, Entry(key=KEY, value=name)) for name in failed):
        return Left()
    packages = packages_of(given.evidence)
    with_it = {name: needing(name, packages) for name in failed}
    going = {each for names in with_it.values() for each in names}
    if why := _kept(needed, failed, going, len(given.config.skip_packages)):
        return Left(why=why)
    reason = "nothing else needs it" if needed.shell else "the command does not need it"
    whole = len(failed) == 1
    return Left(
        changes=tuple(
            _change(name, found, given, others=with_it[name][1:], reason=reason, whole=whole)
            for name, found in failed.items()
        )
    )


def _packages(found: Explanation, given: Given) -> tuple[str, ...]:
    """Return the packages of the repository in which a step stopped; none where one of them is another's."""
    own = {m.file.rpartition("/")[0]: m.name for m in packages_of(given.evidence).built if m.name}
    place = given.plan.workspace.folder
    before = f"{place}/".removeprefix(f"{WORKSPACE}/src/") if place != WORKSPACE else ""
    names = []
    for each in found.packages:
        if each in own.values():
            names.append(each)
            continue
        path = each.removeprefix(before) if place != WORKSPACE else f"src/{each}"
        at = owner(f"{path}/CMakeLists.txt", own) if place == WORKSPACE or f"{each}/".startswith(before) else None
        if at is None:
            return ()
        names.append(at)
    return tuple(dict.fromkeys(names))


def _asking(found: Explanation, given: Given) -> tuple[str, ...]:
    """Return the packages that ask for the library in whose stage a step stopped, if it did in one."""
    library = _library(found)
    by_name = asking(given.evidence, packages_of(given.evidence), (library,)) if library else {}
    return by_name.get(library, ())


def _library(found: Explanation) -> str:
    match = None if found.packages else _LIBRARY.search(found.log)
    return match[1] if match else ""


def _kept(needed: Needs, failed: Mapping[str, Explanation], going: Collection[str], before: int) -> str:
    """Return why packages must be built, ``""`` if the image is of use without them."""
    stopped = _stopped(failed)
    if lost := needed.of(needed.started) & {*going}:
        who = "the page" if needed.shell else "the command"
        return f"{stopped}, and {who} needs {min(lost & {*failed} or lost)}"
    stay = {name for name, m in needed.built.items() if name not in going and not m.metapackage}
    if not stay:
        return f"{stopped}, and no other package would be left"
    if not needed.shell:
        return ""
    if {*going} - {*failed} or needed.of(stay) & {*failed}:
        return f"{stopped}, and other packages need it"
    if (before + len(failed)) * _SHARE > before + len(failed) + len(stay):
        return f"{stopped}, and more than half of the packages would be left out"
    return ""


def _stopped(failed: Mapping[str, Explanation]) -> str:
    names, one = ", ".join(sorted(failed)), len(failed) == 1
    if libraries := {library for found in failed.values() if (library := _library(found))}:
        return f"{', '.join(sorted(libraries))} cannot be built, which {names} {'asks' if one else 'ask'} for"
    return f"{names} {'does' if one else 'do'} not compile"


def _change(
    name: str, found: Explanation, given: Given, *, others: Collection[str], reason: str, whole: bool
) -> Change:
    folder = next(m.file.rpartition("/")[0] for m in packages_of(given.evidence).built if m.name == name)
    library = _library(found)
    what, place = said(found, given, "" if library else folder, whole=whole)
    stops = f"needs {library}, which cannot be built" if library else "does not compile"
    at = f" at {place}" if place else ""
    more = f"; with it {', '.join(others)}, which cannot be built without it" if others else ""
    return Change(
        key=KEY,
        value=name,
        failure=found.id or "",
        certain=True,
        asked=Asked(what=what, place=place),
        why=f"{stops}: {what}{at}; {reason}{more}",
    )


def told(changes: Collection[Change]) -> Iterator[str]:
    """Yield what each change does, as it is said after the number of a repair."""
    for change in changes:
        if change.key == KEY:
            yield f"leaves out {change.value}, which {change.why}"
        elif change.key == generated.KEY:
            yield f"generates a Dockerfile: {change.why}"
        else:
            yield f"adds {change.told}"


def without_useless(changes: Collection[Change], answer: Answer, given: Given) -> list[Change]:
    """Return the changes without those that were made for what fails still."""
    still = {(found.id, asked(found, given).what) for found in answer.explanations if found.id}
    return [
        change for change in changes if change.key == generated.KEY or (change.failure, change.asked.what) not in still
    ]
