"""Keys that are a known one but for a slip: ``rclpp`` for ``rclcpp``, ``roconsole`` for ``rosconsole``."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import pairwise

_SHORTEST = 5
"""Fewest letters of a name with a slip: shorter ones are near to too many."""


def meant(name: str, known: Collection[str]) -> tuple[str, ...]:
    """Return the known names that have one letter more, less or another than a name, or two of them swapped, sorted.

    What counts differs by a digit, and is no slip.
    """
    if len(name) < _SHORTEST:
        return ()
    here = set(_with_a_gap(name)) | set(_swapped(name))
    begins, ends = name[: (len(name) - 1) // 2], name[-((len(name) - 1) // 2) :]  # a slip leaves one of them whole
    alike = (each for each in known if each.startswith(begins) or each.endswith(ends))
    near = (each for each in alike if abs(len(each) - len(name)) <= 1 and each != name)
    return tuple(sorted(each for each in near if not here.isdisjoint((each, *_with_a_gap(each)))))


def _with_a_gap(name: str) -> Iterator[str]:
    """Yield a name with a gap in place of each letter, and with one between every two, but for digits."""
    for at in range(len(name) + 1):
        yield f"{name[:at]}*{name[at:]}"
        if at < len(name) and not name[at].isdigit():
            yield f"{name[:at]}*{name[at + 1 :]}"


def _swapped(name: str) -> Iterator[str]:
    for at, (one, two) in enumerate(pairwise(name)):
        yield f"{name[:at]}{two}{one}{name[at + 2 :]}"
