"""Variables of an author's Dockerfile and its service that ROS, a robot's packages or the tree's programs read."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.facts import Mention
from roslab.evidence.prose.exports import read_by_launch, read_by_program
from roslab.evidence.service import Service
from roslab.knowledge.robot_variables import of_robots
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_NAME = pattern(r"[A-Za-z_]\w*")
_VALUE = pattern(r"(?!(?:\d+\.){3}\d+)[\w.+-]{1,60}")
"""A value that is a word, and no path or address of a machine."""


def set_for_ros(
    repository: Repository, file: str, written: Iterable[tuple[str, str, int]], service: Service | None
) -> tuple[Mention, ...]:
    """Return each such variable once, with the value that the service gives it, else that of the Dockerfile.

    ``written``: the variables of the Dockerfile's last stage, each with its value and line; the last one of a name
    counts.
    """
    found = {name: (value, file, line) for name, value, line in written}
    if service:
        found |= {name: (value, service.file, service.line) for name, value in service.environment}
    return tuple(
        Mention(topic="variable", value=f"{name}={value}", source="dockerfile", file=where, line=line, text=name)
        for name, (value, where, line) in found.items()
        if _NAME.fullmatch(name) and _VALUE.fullmatch(value) and _is_read(name, repository)
    )


def _is_read(name: str, repository: Repository) -> bool:
    return of_robots(name) or read_by_launch(name, repository) or read_by_program(name, repository)
