"""Packages without which the default command does not start: the build stops where one of them fails."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.launch_calls import started_launch
from roslab.decide.programs import in_packages
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.sought import tried
from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence
from roslab.knowledge.released import released
from roslab.values.pattern import pattern
from roslab.values.words import line_of

_STARTED = pattern(r"\b(?:roslaunch|rosrun|ros2 launch|ros2 run) ([A-Za-z]\w*)(?= )")
_LAUNCHED = pattern(r"\b(?:roslaunch|ros2 launch) [^;&|'\"]{1,2000}")
"""The call of a launch file, also where a shell makes it."""
_SHELL = "bash"
_WORD = pattern(r"[\w./-]+\.(?:py|(?:ba)?sh)\b")


def must_build(
    evidence: Evidence,
    command: tuple[str, ...] | str,
    packages: Packages,
    sources: Sources,
    *,
    left_out: Collection[str],
    ros_distro: str | None,
) -> tuple[str, ...]:
    """Return the packages that the default command names, and those that its launch file starts or includes, in turn.

    Of the latter those of the workspace, and those that a clone may bring: what the distribution has is installed where
    a clone's does not build. ``left_out``: those that are not built anyway, or may fail: a launch file starts its other
    nodes without them, and what they lack is told. Where a shell is started, those that the page at the root launches.
    """
    line = line_of(command)
    own = {manifest.name for manifest in packages.built} - {*left_out}
    there, has = {*own, *sources.names, *tried(sources.sought)}, released(ros_distro or "")
    launched = (
        name
        for name in _launched(evidence, line)
        if name not in left_out and (name in there or (name not in has and sources.may_hold(name)))
    )
    said = (name for name in of_pages(evidence) if line == _SHELL and name in own)
    by_name = in_packages(evidence).get(line.partition(" ")[0])
    return tuple(
        dict.fromkeys(
            (*filter(None, (by_name,)), *_STARTED.findall(line), *_called(evidence, line, packages), *launched, *said)
        )
    )


def of_pages(evidence: Evidence) -> Iterator[str]:
    """Yield the packages of which the page at the root launches something, even a file that they do not have."""
    for said in evidence.mentions:
        if said.topic in {"command", "unlaunched"} and said.source == "readme" and "/" not in said.file:
            yield from (match[1] for match in [_STARTED.match(said.value)] if match)


def _called(evidence: Evidence, line: str, packages: Packages) -> Iterator[str]:
    """Yield the packages of the tree of which the script that a command starts launches something, in a string."""
    words = [word.removeprefix("./") for word in _WORD.findall(line)]
    own = {manifest.name for manifest in packages.built}
    for mention in evidence.mentions:
        if mention.topic == "calls" and mention.value in own:
            name = mention.file.rpartition("/")[2]
            if any(word.rpartition("/")[2] == name and mention.file.endswith(word) for word in words):
                yield mention.value


def _launched(evidence: Evidence, line: str) -> Iterator[str]:
    """Yield the package of each launch file that a command starts, and those that it needs in any case."""
    for match in _LAUNCHED.finditer(line):
        launch = started_launch(evidence, tuple(match[0].split()))
        if launch is None:
            continue
        if launch.package:
            yield launch.package
        for asked in (*launch.dependencies, *launch.reached):
            if asked.namespace == "ros" and asked.strength != "optional":
                yield asked.name
