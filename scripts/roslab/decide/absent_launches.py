"""Launch files that the pages start and that the packages of the tree do not have."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.decision import Choice
from roslab.decide.filled_in import PLACEHOLDER
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence, Mention
from roslab.values.numbered import first_of_its_kind, numbered

MOST = 5


def decide_absent_launches(evidence: Evidence, kind: Kind) -> Choice[None]:
    """Return a warning for each such file, with one of almost that name, if the package has one."""
    start = {"ros1": "roslaunch", "ros2": "ros2"}.get(kind)
    own = packages_of(evidence).names
    found: dict[tuple[str, str], Mention] = {}
    for mention in evidence.mentions:
        if mention.topic == "unlaunched":
            program, package, name = mention.value.split()
            names = _names(package, evidence)
            if program == start and package in own and not (PLACEHOLDER.search(name) or numbered(name, names)):
                found.setdefault((package, name), mention)
    if not found:
        return Choice(answer=None)
    from difflib import get_close_matches  # noqa: PLC0415 - few pages start what is not there

    told = []
    for (package, name), mention in [*found.items()][:MOST]:
        names = _names(package, evidence)
        near = get_close_matches(name, names, n=1)
        hint = f"; it has {first_of_its_kind(near[0], names)}" if near else ""
        message = f"the page starts {name} of the package {package}, which has no such launch file{hint}"
        told.append(warn(message, mention))
    return Choice(answer=None, warnings=tuple(told))


def _names(package: str, evidence: Evidence) -> list[str]:
    return [each.file.rpartition("/")[2] for each in evidence.launch if each.package == package]
