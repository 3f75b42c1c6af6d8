"""Which Python, by which manager, with which packages."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.decision import Python, Reason, Warning_
from roslab.evidence.facts import Evidence


def decide_python(
    evidence: Evidence, config: Config, kind: Kind, ubuntu: str | None, ros_distro: str | None
) -> tuple[Python, tuple[Reason, ...], tuple[Warning_, ...]]:
    """Return the Python part of the image; ``ubuntu`` is ``None`` where the base is still to be chosen."""
    del evidence, ubuntu
    ros = kind in {"ros1", "ros2"} or ros_distro is not None
    return Python(version=config.base.python, manager="system" if ros else "venv"), (), ()


def specifiers(evidence: Evidence, python: Python) -> tuple[str, ...]:
    """Return every requirement line that the image installs: its own, those of the files, the projects and conda."""
    del evidence
    return python.pip + python.pip_guessed
