"""Pins that a bot raised past every Python that the rest of their list has wheels for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import RequirementFile
from roslab.knowledge.pinned_pythons import together
from roslab.values.requirement import Requirement
from roslab.values.version import Version


def raised_pins(files: Iterable[RequirementFile]) -> Iterator[Warning_]:
    """Yield a warning for each such pin, with the newest release of before that a Python has beside the others."""
    for file in files:
        pins = {each.key: each for each in file.requirements if each.release and not (each.url or each.marker)}
        for asked in pins.values():
            if found := _before(asked, file, pins):
                release, python = found
                why = f"no Python has wheels for it and for all other pins of {file.file}, and a bot raised it"
                advice = f"{asked.name}=={release} of before fits them with Python {python}: pin that one again"
                yield warn(f"{asked.written}: {why}; {advice}", asked)


def _before(asked: Requirement, file: RequirementFile, pins: dict[str, Requirement]) -> tuple[str, str] | None:
    """Return the newest release from which a pin was raised and that fits, with the Python; ``None`` if none does."""
    steps = {after: before for name, before, after in reversed(file.raised) if name == asked.key}
    if not steps:
        return None
    others = [(key, each.release or "") for key, each in pins.items() if key != asked.key]
    if together(others) is None:
        return None
    release = next((before for after, before in steps.items() if Version(after) == Version(asked.release or "0")), None)
    while release:
        if python := together([*others, (asked.key, release)]):
            return release, python
        release = steps.pop(release, None)
    return None
