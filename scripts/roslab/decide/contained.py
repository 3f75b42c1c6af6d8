"""What the containers of the author's own Dockerfiles start, where pages run nothing and another image is built."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate
from roslab.decide.other_runs import runs_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def contained(evidence: Evidence, kind: Kind, *, compiled: bool) -> tuple[Candidate, ...]:
    """Return these programs as they are started from the root: of a repository of ROS nodes and launch files alone."""
    starts = [m for m in evidence.mentions if m.topic == "contained"]
    if not starts:
        return ()
    by = {(m.file, m.line): m.text for m in starts}
    return tuple(
        replace(each, why=f"a container of {by[each.file, each.line]} starts it", strong=False, contained=True)
        for each in runs_of(starts, evidence, kind, compiled=compiled)
        if not any(map(places.test, each.files))
    )


def only_contained(candidates: Iterable[Candidate]) -> Candidate | None:
    """Return the one that all of them start, ``None`` where there are several or none."""
    found = {each.argv: each for each in candidates if each.contained and not each.cut}
    return next(iter(found.values())) if len(found) == 1 else None
