"""Packages whose page runs nothing but programs that CMake makes only outside of a workspace of ROS."""

from __future__ import annotations

import posixpath

from roslab.config.model import Kind
from roslab.decide.built_by_pages import page_of_cmake
from roslab.decide.candidate import LAUNCHERS
from roslab.decide.programs import outside_of_packages
from roslab.evidence.facts import Evidence, Mention

_OF_ROS = frozenset({*LAUNCHERS, "roscore"})


def run_outside(evidence: Evidence) -> Mention | None:
    """Return where a page at the root runs such a program and builds by CMake, if it starts nothing else, nor by ROS.

    The wrapper for ROS is an extra of such a project.
    """
    if not any(project.outside or project.without_options for project in evidence.cmake) or not page_of_cmake(evidence):
        return None
    kinds: tuple[Kind, ...] = ("ros1", "ros2")
    outside = {program.name for kind in kinds for program in outside_of_packages(evidence, kind)}
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme" and m.value.split()]
    started = {posixpath.basename(m.value.split()[0]): m for m in reversed(said)}
    ran = started.keys() & {name for project in evidence.cmake for name, _ in project.executables}
    if not ran <= outside or not _OF_ROS.isdisjoint(started):
        return None
    return next((said for name, said in started.items() if name in ran and "/" not in said.file), None)
