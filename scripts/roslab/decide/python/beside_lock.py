"""Lists that contradict the lock beside them, and are the second way to install what the lock installs."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from roslab.decide.decision import Warning_
from roslab.decide.python.machine_lists import not_installed
from roslab.decide.python.pins import DEVELOPMENT
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.evidence.locked import Locked
from roslab.values.requirement import Requirement


def beside_lock(evidence: Evidence) -> frozenset[str]:
    """Return the lists at the root that yield to the lock there: no page installs one before the manager of the lock.

    Each asks for nothing but what the lock has for the project itself, one at least in another release.
    """
    own = [asked for project in evidence.python if not project.folder for asked in project.requirements]
    wanted = {asked.key for asked in own if asked.package and asked.role not in {"extra", "test"}}
    if not (wanted and evidence.locked) or "/" in evidence.locked[0].requirement.file:
        return frozenset()
    by_name: dict[str, list[Locked]] = {}
    for each in evidence.locked:
        by_name.setdefault(each.requirement.key, []).append(each)
    one = {name: same[0] for name, same in by_name.items() if len(same) == 1}
    given = needed(wanted, by_name) & {*by_name}
    found = [file for file in evidence.requirements if "/" not in file.file and _yields(file, given, one)]
    first = _first(evidence, {file.file for file in found}) if found else ""
    return frozenset(file.file for file in found if not first)


def left_to_lock(evidence: Evidence, chosen: Collection[RequirementFile]) -> Iterator[Warning_]:
    """Yield a warning for each of these lists that is not among the chosen files."""
    if left := beside_lock(evidence):
        why = f"{evidence.locked[0].requirement.file} has another release of what it lists"
        yield from not_installed(evidence, left, chosen, why)


def _yields(file: RequirementFile, given: Collection[str], one: Mapping[str, Locked]) -> bool:
    plain = all(each.package and each.key in given for each in file.requirements) and not (
        file.options or file.includes
    )
    return file.purpose == "run" and plain and any(differs(each, one) for each in file.requirements)


def _first(evidence: Evidence, lists: Collection[str]) -> str:
    """Return the list that is installed before the lock's manager is called, or ``""``."""
    for asked in _told(evidence):
        if asked.role == "project" and asked.group:
            return ""
        if asked.role == "file" and asked.written.rpartition("/")[2] in lists:
            return asked.written
    return ""


def _told(evidence: Evidence) -> Iterator[Requirement]:
    yield from (asked for asked in evidence.prose_pip if not DEVELOPMENT.search(asked.file))
    for authored in evidence.dockerfiles:
        yield from authored.requirements if authored.purpose in {"project", "deploy"} else ()


def differs(asked: Requirement, one: Mapping[str, Locked]) -> bool:
    """Tell whether a manifest asks for another release than the lock has: the lock is older, or of another part."""
    release = one[asked.key].requirement.release if asked.key in one else None
    return release is not None and not asked.specifier.contains(release, prereleases=True)


def needed(names: set[str], by_name: Mapping[str, Iterable[Locked]]) -> set[str]:
    """Return the names and all that they need, directly or not."""
    while more := {need for name in names for each in by_name.get(name, ()) for need in each.needs} - names:
        names = names | more
    return names
