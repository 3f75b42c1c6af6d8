"""Programs that only help the one that a repository is called after: a page may start them first."""

from __future__ import annotations

import re
from collections.abc import Iterable

from roslab.decide.candidate import LAUNCHERS, Candidate, is_python, launched_by, program_of
from roslab.decide.first_command import serves
from roslab.decide.purposes import alike, words_of
from roslab.decide.reasons import page_of
from roslab.decide.sections import about_running
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

_HELPS = pattern(
    r"(?:^|_)(?:(?:robot_|joint_)?state_publisher|static_transform_publisher|transform_publisher|tf2?_publisher|teleop\w*|"
    r"rviz2?|urdf|description|joy(?:stick)?)(?:_|$)",
    re.IGNORECASE,
)
"""What tells others of a robot's frames, steers it or shows it, in the name of a package or a program.

https://index.ros.org/p/robot_state_publisher/ and its like, 2026-11-27
"""
_SHOWS = pattern(r"(?:^|_)(?:demos?|examples?|samples?)(?:_|$)", re.IGNORECASE)
"""The name of a package that shows something: beside others, what these can be used for."""
_SUFFIX = pattern(r"[_-](?:ros2?|node|pkg|py|cpp)$")
_TITLE = " / "


def behind_helpers(first: Candidate, candidates: Iterable[Candidate], evidence: Evidence) -> Candidate:
    """Return what the page starts after a helper and shares most words with the repository's name or the page's title.

    ``first`` where it is no helper, or nothing that is as much meant to be run shares more of them.
    """
    candidates = tuple(candidates)
    if is_python(first) and serves(first):
        return _behind_node(first, candidates)
    first = _behind_optional(first, candidates, evidence)
    first = _behind_whole(first, candidates)
    if first.argv[0] not in LAUNCHERS or not any(map(_HELPS.search, _names(first))):
        return first
    words = {word for name in (*first.names, first.heading.partition(_TITLE)[0]) for word in words_of(name)}
    best, most = first, _shared(first, words)
    for each in candidates:
        same = each.strong and each.file == first.file and each.argv[0] in LAUNCHERS and not (each.cut or each.lacking)
        meant = about_running(each.heading) >= about_running(first.heading)
        if same and meant and not any(map(_HELPS.search, _names(each))) and (shared := _shared(each, words)) > most:
            best, most = each, shared
    return best


def _behind_node(first: Candidate, candidates: Iterable[Candidate]) -> Candidate:
    """Return the only node or launch file of the packages, if it starts, where pages run but what serves it.

    It draws what the node wrote, or makes what that reads: pages of ROS may show the node in a launch file alone.
    """
    started = {program_of(c.argv): c for c in candidates if c.argv[0] in LAUNCHERS}
    if len(started) != 1:
        return first
    (node,) = started.values()
    if not _whole(node):
        return first
    return replace(node, why=f"{node.why}, and {page_of(first.file)} runs only what serves it")


def _behind_whole(first: Candidate, candidates: Iterable[Candidate]) -> Candidate:
    """Return what the page launches before a demonstration of something else and shares a word with the repository.

    ``ar_demo`` of VINS shows what the repository's own estimator is good for, and its section may be called "Demo".
    """
    package = program_of(first.argv)[-2] if first.argv[0] in LAUNCHERS else ""
    words = {word for name in first.names[:1] for word in words_of(name)}
    if not _SHOWS.search(package) or _shared(first, words):
        return first
    for each in candidates:
        before = each.strong and each.file == first.file and each.line < first.line and launched_by(each.argv)
        if before and _whole(each) and about_running(each.heading) >= 0 and _shared(each, words):
            return each
    return first


def _whole(candidate: Candidate) -> bool:
    """Tell whether a command starts as it is: nothing that its launch file needs is left to the reader, or gone."""
    return not (candidate.cut or candidate.lacking or candidate.unmade or candidate.behind)


def _behind_optional(first: Candidate, candidates: Iterable[Candidate], evidence: Evidence) -> Candidate:
    """Return what the page starts of the same package that is called like it, where not everybody takes the first step.

    It may leave arguments to the reader: what the package is for is meant, and not what makes its data.
    """
    steps = {(m.file, m.line) for m in evidence.mentions if m.topic == "optional_step"}
    if first.argv[0] not in LAUNCHERS or (first.file, first.line) not in steps:
        return first
    package, program = program_of(first.argv)[-2:]
    for each in candidates:
        named = program_of(each.argv)[-2:]
        same = (
            each.strong
            and each.file == first.file
            and each.argv[0] in LAUNCHERS
            and (each.file, each.line) not in steps
        )
        if same and named[0] == package and named[1] != program and _alike(named[1], package):
            return each
    return first


def _alike(program: str, package: str) -> bool:
    """Tell whether a program has the name of its package, which may end in the name of ROS or of what it has."""
    name, whole = bare_name(program.partition(".")[0]), bare_name(package)
    return bool(name) and name in {whole, bare_name(_SUFFIX.sub("", package))}


def _names(candidate: Candidate) -> tuple[str, ...]:
    """Return the names of the package and the program."""
    return tuple(name.partition(".")[0] for name in program_of(candidate.argv)[-2:])


def _shared(candidate: Candidate, words: Iterable[str]) -> int:
    """Return how many of the words are in the names of the package or the program, in whichever form."""
    own = {word for name in _names(candidate) for word in words_of(name)}
    return sum(any(alike(word, each) for each in own) for word in words)
