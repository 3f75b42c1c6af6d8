"""The launch file or program that is the use of a repository although its name says that it serves another one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from roslab.decide.candidate import LAUNCHERS, Candidate, launched_by, program_of
from roslab.decide.reasons import of_readme
from roslab.decide.sections import about_running
from roslab.values.pattern import pattern

_VIEWS = pattern(r"(?:^|[_.-])(?:rqt|rviz2?)(?:[_.-]|$)", re.IGNORECASE)
"""The name of a launch file that opens windows for what others do."""
_TRIES = pattern(r"(?:^|[_.-])(?:bench\w*|tests?)(?:[_.-]|$)", re.IGNORECASE)
"""The name of one that has the code do something to be measured by."""
_STEERS = pattern(r"(?:^|[_.-])(?:teleop\w*|keyboard|joystick|joy|gamepad)(?:[_.-]|$)", re.IGNORECASE)
"""The name of a program with which somebody steers what others start."""
_TESTS = pattern(r"\btest(?:s|ing)?\b", re.IGNORECASE)


def only_launched(written: Sequence[Candidate]) -> list[Candidate]:
    """Return the launch file that the README runs in a section about use, where it runs no other: that is the use.

    Viewers beside it are no other. Of several that measure what the code does, and that one section runs, the first.
    """
    launched = [c for c in written if launched_by(c.argv)]
    launched = [c for c in launched if not _VIEWS.search(_name(c))] or launched
    said = [c for c in launched if "/" not in c.file and of_readme(c.file) and about_running(c.heading) > 0]
    if len({program_of(c.argv) for c in launched}) == 1:
        return said[:1]
    sections = {(c.file, c.heading) for c in launched}
    return said[:1] if len(sections) == 1 and all(_TRIES.search(_name(c)) for c in launched) else []


def launched_alone(candidates: Iterable[Candidate]) -> list[Candidate]:
    """Return the launch file that all pages start, in a section about use, where they start nothing else.

    Its name may say that it serves another program, ``gen_path.launch``: there is none.
    """
    written = [c for c in candidates if c.strong]
    if len({program_of(c.argv) for c in written}) != 1 or not launched_by(written[0].argv):
        return []
    return [c for c in written if about_running(c.heading) > 0 and not _TESTS.search(c.heading)]


def only_run(written: Sequence[Candidate], found: Iterable[Candidate]) -> list[Candidate]:
    """Return the node that the README runs in a section about use, where it runs nothing else: that is the use.

    What is ``found`` beside it may be compiled, but no launch file: such a one starts what the node serves.
    """
    if len({program_of(c.argv) for c in written}) != 1 or any(launched_by(c.argv) for c in found):
        return []
    said = [c for c in written if c.argv[0] in LAUNCHERS and "/" not in c.file and of_readme(c.file)]
    said = [c for c in said if not (_VIEWS.search(_name(c)) or _STEERS.search(_name(c)) or _TESTS.search(c.heading))]
    return [c for c in said if any(about_running(title) > 0 for title in c.heading.split(" / "))][:1]


def _name(candidate: Candidate) -> str:
    return program_of(candidate.argv)[-1].rpartition("/")[2].partition(".")[0]
