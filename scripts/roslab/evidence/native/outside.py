"""Programs that CMake makes only outside of a workspace of ROS: ``if(NOT CATKIN_DEVEL_PREFIX)``."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.lex.truth import workspace_holds

_EACH = (1, 2)
"""The versions of ROS."""


def of_workspace(condition: str) -> bool:
    """Tell whether the build tool decides a condition."""
    return any(workspace_holds(condition, ros) is not None for ros in _EACH)


def outside_of_workspaces(
    name: str, conditions: Iterable[str], into: dict[tuple[str, int], None], *, again: bool
) -> None:
    """Note a program with each version of ROS in whose workspace no call adds it; ``again``: one was read before."""
    conditions = tuple(conditions)
    for ros in _EACH:
        if all(workspace_holds(each, ros) is not False for each in conditions):
            into.pop((name, ros), None)
        elif not again:
            into[name, ros] = None
