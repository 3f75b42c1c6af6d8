"""What a list of exact releases tells of the Python that it was written on, where nothing names one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby

from roslab.decide.python.pins import Pin
from roslab.decide.python.pythons import PREFERRED
from roslab.decide.python.ranges import Range
from roslab.decide.python.weights import VersionWeight as Weight
from roslab.decide.reasons import because
from roslab.values.version import Version

FEWEST = 3
"""Releases that show by more than chance that there was no newer one for the author's Python."""
_LISTED = 2
"""Of ``Pin.trust``: a manifest or an environment."""
_MOST = 4
"""Most of them that a reason names."""


def ranges_of_lists(pins: Iterable[Pin]) -> Iterator[Range]:
    """Yield the Python for which several of a list's releases are each the last, then those on which a release runs."""
    listed = [pin for pin in pins if pin.trust >= _LISTED and pin.release]
    for _, group in groupby(sorted(listed, key=lambda pin: pin.requirement.file), key=lambda pin: pin.requirement.file):
        releases = {pin.name: pin for pin in group}
        yield from _last(releases)
    for pin in listed:
        yield from _running(pin)


def _running(pin: Pin) -> Iterator[Range]:
    """Yield the Pythons on which a release runs, where it does not run on newer ones."""
    from roslab.knowledge.runs_up_to import runs_up_to  # noqa: PLC0415 - as below

    if newest := runs_up_to(pin.name, pin.release or ""):
        why = f"{pin.requirement.written} runs on no newer one"
        reason = because("python", newest, why, pin.requirement, weight=Weight.PINS + pin.trust)
        yield Range(frozenset(each for each in PREFERRED if Version(each) <= Version(newest)), reason)


def _last(releases: Mapping[str, Pin]) -> Iterator[Range]:
    """Yield the Python of the most of them, if they are several."""
    found: dict[str, list[Pin]] = {}
    for name, pin in releases.items():
        from roslab.knowledge.last_for_python import last_for_python  # noqa: PLC0415 - few trees pin releases

        if python := last_for_python().get((name, pin.release or "")):
            found.setdefault(python, []).append(pin)
    python, last = max(found.items(), key=lambda each: len(each[1]), default=("", []))
    if len(last) >= FEWEST:
        named = ", ".join(pin.requirement.written for pin in last[:_MOST])
        more = f" and {len(last) - _MOST} more" if len(last) > _MOST else ""
        why = f"{named}{more} are each the last release for it"
        first = last[0]
        reason = because("python", python, why, first.requirement, weight=Weight.PINS + first.trust)
        yield Range(frozenset({python}), reason)
