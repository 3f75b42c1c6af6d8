"""Packages without which the default command does not start: the build stops where one of them fails."""

from __future__ import annotations

from roslab.values.pattern import pattern
from roslab.values.words import line_of

_STARTED = pattern(r"\b(?:roslaunch|rosrun|ros2 launch|ros2 run) ([A-Za-z]\w*)(?= )")


def must_build(command: tuple[str, ...] | str) -> tuple[str, ...]:
    """Return the packages that the default command names."""
    return tuple(dict.fromkeys(_STARTED.findall(line_of(command))))
