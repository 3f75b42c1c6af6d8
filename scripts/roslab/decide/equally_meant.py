"""Which comes first of commands that equally near pages have everybody run: of the whole, and without the robot."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from roslab.decide.candidate import LAUNCHERS, Candidate, program_of
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

_ROBOT = pattern(r"(?:^|[\s_.-])(?:hardware|drivers?|bring_?up)(?=[\s_.-]|$)", re.IGNORECASE)
_SIMULATED = pattern(r"(?:^|[\s_.-])(?:sim|simulat\w*?|gazebo|demos?)(?=[\s_.-]|$)", re.IGNORECASE)
"""What the names of packages, nodes and launch files call the robot itself, and what stands in for it."""
_NUMBER = pattern(r"\d+$")


def of_whole(candidate: Candidate) -> bool:
    """Tell whether a page below the root is of the folder called like the repository: ``walker/`` of ``walker2``."""
    folder = candidate.file.rpartition("/")[0].rpartition("/")[2]
    return bool(folder) and _unnumbered(folder) in map(_unnumbered, candidate.names)


def without_robot(ordered: Sequence[Candidate], rank: Callable[[Candidate], object]) -> Candidate:
    """Return the first command, or the first of the same rank that starts a simulation where that one needs the robot.

    So it is where the first shows the robot's model alone. ``rank``: what makes two of them equally meant. What the
    same section runs later is the next step after it.
    """
    first = ordered[0]
    if first.argv[0] not in LAUNCHERS or not (first.views or _needs_robot(first)):
        return first
    for each in ordered[1:]:
        whole = not (each.cut or each.lacking or each.unmade or each.elsewhere or each.behind or each.demands)
        whole = whole and not each.views
        apart = (each.file, each.heading) != (first.file, first.heading)
        if whole and apart and each.argv[0] in LAUNCHERS and _simulates(each) and rank(each) == rank(first):
            return each
    return first


def _needs_robot(candidate: Candidate) -> bool:
    return bool(_ROBOT.search(_names(candidate))) and not _simulates(candidate)


def _simulates(candidate: Candidate) -> bool:
    return bool(_SIMULATED.search(_names(candidate)))


def _names(candidate: Candidate) -> str:
    return " ".join(program_of(candidate.argv)[-2:])


def _unnumbered(name: str) -> str:
    return _NUMBER.sub("", bare_name(name))
