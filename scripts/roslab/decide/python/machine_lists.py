"""Requirement files that list what a machine with ROS or an Anaconda had installed, with packages that no index has."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Literal

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.knowledge.guesses import tooling

FEWEST = 3
"""Fewest of ROS's own packages, or Anaconda's, each of one version, that only such a list has.

One or two may be a reader's wish.
"""
_OF: dict[Literal["ros", "anaconda"], tuple[str, str]] = {
    "ros": ("a machine with ROS", "ROS's own packages too, which pip cannot install"),
    "anaconda": ("an Anaconda", "conda's own packages too, not all of which pip can install"),
}
"""What had such a list's packages installed, and what is said of its own among them."""


def of_machines(evidence: Evidence) -> frozenset[str]:
    """Return the paths of the lists that ``pip freeze`` made on such a machine, not a hand for the code."""
    return frozenset(path for path, _ in _found(evidence))


def of_anacondas(evidence: Evidence) -> frozenset[str]:
    """Return the paths of such lists of an Anaconda, with hundreds of packages and frameworks that no code may need."""
    return frozenset(path for path, asked_by in _found(evidence) if asked_by == "anaconda")


def machine_lists(evidence: Evidence, chosen: Collection[RequirementFile]) -> Iterator[Warning_]:
    """Yield a warning for each of the lists that is not among the chosen files."""
    for path, asked_by in _found(evidence):
        machine, own = _OF[asked_by]
        why = f"it lists what {machine} had installed, {own}"
        yield from not_installed(evidence, {path}, chosen, why)


def _found(evidence: Evidence) -> Iterator[tuple[str, Literal["ros", "anaconda"]]]:
    """Yield each such list, and whose own packages it has."""
    pinned: dict[str, list[str]] = {}
    for file in evidence.requirements:
        pins = (asked.key for asked in file.requirements if asked.written.startswith(f"{asked.name}=="))
        pinned.setdefault(file.file, []).extend(pins)
    for path, keys in pinned.items():
        asked_by = next((each for each in _OF if sum(key in tooling(each) for key in keys) >= FEWEST), None)
        if asked_by:
            yield path, asked_by


def not_installed(
    evidence: Evidence, lists: Collection[str], chosen: Collection[RequirementFile], why: str
) -> Iterator[Warning_]:
    """Yield a warning for each of these lists that is not among the chosen files."""
    for file in evidence.requirements:
        if file.file in lists and file not in chosen:
            yield warn(f"{file.file} is not installed: {why}; `requirements` in roslab.yaml installs it", file)
