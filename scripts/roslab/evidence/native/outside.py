"""Programs that CMake makes only outside of a workspace of ROS (``if(NOT catkin_FOUND)``) or without an option."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.lex.truth import workspace_holds
from roslab.values.pattern import pattern

_EACH = (1, 2)
"""The versions of ROS."""
_WITHOUT = pattern(r"NOT \((?:OFF|ON) (\w+)\)|NOT (\w+)")
"""The other branch of an option, or the branch of one that is off."""


def of_workspace(condition: str) -> bool:
    """Tell whether the build tool decides a condition."""
    return any(workspace_holds(condition, ros) is not None for ros in _EACH)


def outside_of_workspaces(
    name: str,
    conditions: Iterable[str],
    into: dict[tuple[str, int], None],
    without: dict[tuple[str, int], frozenset[str]],
    *,
    again: bool,
) -> None:
    """Note a program with each version of ROS in whose workspace no call adds it; ``again``: one was read before.

    ``without``: with each in whose workspace all calls that may add it wait for an option to be off, and which.
    """
    conditions = tuple(conditions)
    off = frozenset(match[1] or match[2] for each in conditions if (match := _WITHOUT.fullmatch(each)))
    for ros in _EACH:
        if all(workspace_holds(each, ros) is not False for each in conditions):
            first = not again or (name, ros) in into
            into.pop((name, ros), None)
            without[name, ros] = off if first else without.get((name, ros), frozenset()) & off
        elif not again:
            into[name, ros] = None
