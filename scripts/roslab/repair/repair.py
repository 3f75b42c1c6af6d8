"""From what a log says and what was planned to the changes of roslab.yaml that repair the build."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.addition import SINGLE, WORDS, has
from roslab.explain.answer import Answer, Explanation
from roslab.explain.signatures import filled
from roslab.knowledge.repairs import LISTS, repairs
from roslab.repair import clones, ways
from roslab.repair.asked import asked, in_log
from roslab.repair.by_hand import yielding
from roslab.repair.change import Change, Given, Repair, Worked
from roslab.repair.ways import WAYS

_MAY_BE_SUBMODULES = (
    "file-missing",
    "make-no-rule",
    "header-missing",
    "ros-header-missing",
    "cmake-package",
    "submodules-not-fetched",
    "python-module-missing",
)
"""Failures that a submodule that is not checked out causes too."""
_HELD = ("header-missing", "cmake-package", "cmake-package-status", "colcon-package-unknown")
"""Failures that name what a package of ROS or a repository may hold by its name."""


def repair(answer: Answer, given: Given) -> Repair:
    """Return the changes of roslab.yaml that the failed steps of a log call for, and why others have none."""
    changes: dict[tuple[str, str], Change] = {}
    refused: dict[str, str] = {}
    places = []
    for found in answer.explanations:
        one = list(_changes(found, given))
        for change in one:
            if isinstance(change, Change):
                changes.setdefault((change.key, change.value), change)
            else:
                refused[found.id or ""] = change
        first = next((change for change in one if isinstance(change, Change)), None)
        places.append(first.asked.place if first else asked(found, given).place if found.id else in_log(found, given))
    return Repair(changes=tuple(changes.values()), refused=tuple(refused.items()), places=tuple(places))


def _changes(found: Explanation, given: Given) -> Iterator[Change | str]:
    """Yield the changes for one failed step, or the reason why there is none."""
    key, worked = _worked(found, given)
    certain = worked.certain and (found.certainty == "certain" or key == "submodules" or _settled(found))
    new = 0
    for value in worked.values:
        change = yielding(
            Change(
                key=key,
                value=value,
                instead=worked.instead,
                failure=found.id or "",
                certain=certain,
                asked=asked(found, given, value),
            ),
            given,
        )
        if not has(given.config, change.entry):
            new += 1
            yield change
    if worked.values and not new:
        yield f"roslab.yaml has {', '.join(worked.values)} already, and that did not help"
    elif not worked.values:
        yield worked.why or "no key of roslab.yaml answers it"


def _settled(found: Explanation) -> bool:
    """Return whether plan and tables settle what the log alone makes likely: a ROS package, a library of the system."""
    known = repairs().get(found.id or "")
    return known is not None and known.way in {"released", "linked", "brought"}


def _worked(found: Explanation, given: Given) -> tuple[str, Worked]:
    """Return the key and the values that repair one failed step."""
    if found.id is None:
        return "", Worked(why="no known cause")
    if found.id in _MAY_BE_SUBMODULES and (worked := ways.submodules(found, given)).values:
        return "submodules", worked
    if (known := repairs().get(found.id)) and known.key:
        if known.way:
            worked = WAYS[known.way](found, given)
            return worked.key or known.key, worked
        return known.key, Worked(values=(filled(known.value, dict(found.names)),))
    for key, values in found.repair:
        if key in (*LISTS, *WORDS, *SINGLE):
            return key, Worked(values=values)
    held = clones.brought(found, given) if found.id in _HELD else None
    return (held.key, held) if held else ("", Worked(why=found.fix))
