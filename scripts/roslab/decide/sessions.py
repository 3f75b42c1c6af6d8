"""What files of tmuxinator and scripts called after starting run, where a page loads them or runs nothing."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Set as AbstractSet

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate, program_of
from roslab.decide.first_command import helps
from roslab.decide.other_runs import runs_of
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace


def in_sessions(evidence: Evidence, kind: Kind, *, compiled: bool, written: bool) -> tuple[Candidate, ...]:
    """Return these runs as they are started from the root: of a repository of ROS nodes and launch files alone.

    What a session starts that a page loads, the page runs. ``written``: pages run something by its name, which comes
    before all other sessions.
    """
    starts = [m for m in evidence.mentions if m.topic == "session"]
    if not starts:
        return ()
    loaded = _loaded(evidence, {m.file for m in starts})
    starts = [m for m in starts if not written or m.file in loaded]
    words = {(m.file, m.line): {*m.value.split()} for m in starts}
    found = [
        replace(each, why=f"{each.file} starts it", strong=False, session=True)
        for each in runs_of(starts, evidence, kind, compiled=compiled)
        # Of a package that the session does not name nothing is meant: its own may be in another repository
        if kind not in {"ros1", "ros2"} or {*program_of(each.argv)} <= words[each.file, each.line]
    ]
    return tuple(_of_page(each, loaded[each.file]) if each.file in loaded else each for each in found)


def _loaded(evidence: Evidence, sessions: AbstractSet[str]) -> dict[str, Mention]:
    """Return the files of sessions that pages load, each with where the first does; two may have one name."""
    found: dict[str, Mention] = {}
    for mention in evidence.mentions:
        if mention.topic == "session_loaded" and mention.source == "readme":
            path = mention.value.removeprefix("./")
            there = [file for file in sessions if f"/{file}".endswith(f"/{path}") or f"/{path}".endswith(f"/{file}")]
            if len(there) == 1:
                found.setdefault(there[0], mention)
    return found


def _of_page(candidate: Candidate, page: Mention) -> Candidate:
    return replace(
        candidate,
        why=f"the page loads {candidate.file}, which starts it",
        file=page.file,
        line=page.line,
        heading=page.heading,
        strong=True,
        session=False,
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
