"""What files of tmuxinator and scripts that are called after starting run, where no page runs anything."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate, program_of
from roslab.decide.first_command import helps
from roslab.decide.other_runs import runs_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def in_sessions(evidence: Evidence, kind: Kind, *, compiled: bool) -> tuple[Candidate, ...]:
    """Return these runs as they are started from the root: of a repository of ROS nodes and launch files alone."""
    starts = [m for m in evidence.mentions if m.topic == "session"]
    if not starts:
        return ()
    written = {(m.file, m.line): {*m.value.split()} for m in starts}
    return tuple(
        replace(each, why=f"{each.file} starts it", strong=False, session=True)
        for each in runs_of(starts, evidence, kind, compiled=compiled)
        # Of a package that the session does not name nothing is meant: its own may be in another repository
        if kind not in {"ros1", "ros2"} or {*program_of(each.argv)} <= written[each.file, each.line]
    )


def of_sessions(candidates: Iterable[Candidate]) -> Candidate | None:
    """Return what all sessions start first of what the tree has, as the smallest of them starts it.

    ``None`` where one starts something else first: the author has several runs, and none is meant before the others.
    """
    by_file: dict[str, list[Candidate]] = {}
    for each in candidates:
        if each.session and not (each.cut or helps(each)):
            by_file.setdefault(each.file, []).append(each)
    programs = {program_of(each[0].argv) for each in by_file.values()}
    if len(programs) != 1:
        return None
    return min(by_file.values(), key=lambda each: (len(each), len(each[0].file)))[0]
