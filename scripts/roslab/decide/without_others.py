"""Commands of pages that need others: what follows the launch of an absent package, nodes of ROS 1 without a master."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.candidate import Candidate
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.released import ever_released
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_PACKAGE = pattern(r"[a-z][a-z0-9_]+")


def clones_others(evidence: Evidence) -> bool:
    """Tell whether other repositories are cloned, whose packages are not known."""
    return any(git.kind in {"vcs", "git_url", "upstream", "submodule"} or git.beside for git in evidence.sources)


def without_others(candidates: Iterable[Candidate], evidence: Evidence) -> tuple[Candidate, ...]:
    """Return what pages run, marked where it comes behind an absent package's launch, or is a node without a master.

    roslaunch starts a master, rosrun none: https://wiki.ros.org/roslaunch, 2026-11-27.
    """
    found = tuple(candidates)
    masters = {m.file for m in evidence.mentions if m.topic == "master"}
    first: dict[tuple[str, str], int] = {}
    started = {(c.file, c.line) for c in found}
    for said in _of_absent(evidence):
        if (said.file, said.line) not in started:
            section = (said.file, said.heading)
            first[section] = min(said.line, first.get(section, said.line))
    return tuple(
        replace(
            each,
            behind=each.line > first.get((each.file, each.heading), each.line),
            alone=each.argv[0] == "rosrun" and each.file not in masters,
        )
        for each in found
    )


def _of_absent(evidence: Evidence) -> Iterator[Mention]:
    """Yield the launches of packages that neither the tree has, nor any distribution released, nor a clone may hold."""
    names = packages_of(evidence).names
    for said in () if clones_others(evidence) else evidence.mentions:
        if said.topic == "command" and said.source == "readme" and "launch " in said.value:
            words = said.value.split()
            package = words[1] if words[0] == "roslaunch" else words[2] if words[:2] == ["ros2", "launch"] else ""
            if _PACKAGE.fullmatch(package) and package not in names and not ever_released(package):
                yield said
