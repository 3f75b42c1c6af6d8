"""Whether a command starts something of the repository, or what others wrote."""

from __future__ import annotations

from roslab.decide.candidate import is_component
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_VIEWER = pattern(r"rviz2?|rqt(?:_\w+)?")
"""A package with no more than a window, which shows nothing without a file."""


def own(argv: tuple[str, ...], evidence: Evidence) -> bool:
    """Tell whether a command starts something that the repository contains, not just a viewer."""
    at = {"roslaunch": 1, "rosrun": 1, "ros2": 2 + is_component(argv)}.get(argv[0], len(argv))
    package = argv[at : at + 1]
    names = {manifest.name for manifest in evidence.manifests}
    if package and package[0] not in names and _VIEWER.fullmatch(package[0]) and len(argv) <= at + 2:
        return False
    return (
        not package or not names or package[0] in names or any(launch.file == package[0] for launch in evidence.launch)
    )
