"""What the containers of the author's own Dockerfiles start, where pages run nothing and another image is built."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate
from roslab.decide.first_command import LAUNCHERS
from roslab.decide.written_commands import calls_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def contained(evidence: Evidence, kind: Kind, *, compiled: bool) -> tuple[Candidate, ...]:
    """Return these programs as they are started from the root: of a repository of ROS nodes and launch files alone."""
    starts = [m for m in evidence.mentions if m.topic == "contained"]
    if not starts:
        return ()
    ros = kind in {"ros1", "ros2"}
    others = (m for m in evidence.mentions if m.topic not in {"command", "contained", "tried"})
    called = (replace(m, topic="command", source="readme") for m in starts)
    found = calls_of(replace(evidence, mentions=(*called, *others)), kind, ros=ros, compiled=compiled)
    by = {(m.file, m.line): m.text for m in starts}
    return tuple(
        replace(each, why=f"a container of {by[each.file, each.line]} starts it", strong=False, contained=True)
        for each in found
        if (each.argv[0] in LAUNCHERS or not ros) and not any(map(places.test, each.files))
    )


def only_contained(candidates: Iterable[Candidate]) -> Candidate | None:
    """Return the one that all of them start, ``None`` where there are several or none."""
    found = {each.argv: each for each in candidates if each.contained and not each.cut}
    return next(iter(found.values())) if len(found) == 1 else None
