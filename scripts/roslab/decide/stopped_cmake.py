"""A plain CMake project that cannot be configured: it is no reason for what is Python beside it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.beside_cpp import mostly_cpp
from roslab.decide.decision import Warning_
from roslab.decide.head_archives import told_of_heads
from roslab.decide.programs import top_of
from roslab.decide.reasons import warn
from roslab.decide.ros.without_code import stopping
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place


def left_to_python(evidence: Evidence) -> bool:
    """Tell whether CMake stops while most of the code is Python, pip installs some of it and a page starts Python."""
    if not any(project.installable for project in evidence.python) or mostly_cpp(evidence) or not _stopped(evidence):
        return False
    said = (m for m in evidence.mentions if m.topic == "command" and m.source == "readme")
    return any(m.value.startswith("python") for m in said)


def told_of_stop(evidence: Evidence, kind: Kind) -> Iterator[Warning_]:
    """Yield a warning for the folder or file that a plain project adds or compiles and the tree does not have.

    And for what it downloads and compiles, another one each time.
    """
    yield from told_of_heads(evidence, kind)
    if kind == "cpp":
        yield from (
            warn(
                f"CMake compiles {path}, which the tree does not have: it is configured with -D{option}=OFF where "
                "nothing else sets that, and makes nothing of what it is for; add the file, or correct the path",
                Place(file=project.file, line=line),
            )
            for project, option, path, line in options_that_lack(evidence)
        )
    stopped = _stopped(evidence) if kind not in {"ros1", "ros2"} else None
    if stopped and (kind == "cpp" or left_to_python(evidence)):
        project, (lacks, line, hint) = stopped
        then = "cmake will stop" if kind == "cpp" else "nothing is compiled"
        yield warn(f"{lacks}: {then}; {hint}", Place(file=project.file, line=line))


def options_that_lack(evidence: Evidence) -> Iterator[tuple[CMakeProject, str, str, int]]:
    """Yield the options of the plain project at the top for which it compiles code that the tree does not have."""
    top = top_of(evidence)
    folder = posixpath.dirname(top.file) if top else ""
    for project in evidence.cmake if top else ():
        if project is top or (project.always and project.top == folder):
            yield from ((project, *each) for each in project.lacking)


def _stopped(evidence: Evidence) -> tuple[CMakeProject, tuple[str, int, str]] | None:
    top = top_of(evidence)
    folder = posixpath.dirname(top.file) if top else ""
    for project in evidence.cmake if top else ():
        ours = project is top or (project.always and project.top == folder)
        if ours and (project.absent or project.without) and (found := stopping(project)):
            return project, found
    return None
