"""Keys that are a known one but for a slip: ``rclpp`` for ``rclcpp``, ``roconsole`` for ``rosconsole``."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Iterator
from functools import cache
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
    half = (len(name) - 1) // 2
    begins, ends = name[:half], name[-half:]  # a slip leaves one of them whole
    names, backwards = _in_order(frozenset(known))
    alike = {*_beginning(begins, names), *(each[::-1] for each in _beginning(ends[::-1], backwards))}
    near = (each for each in alike if abs(len(each) - len(name)) <= 1 and each != name)
    return tuple(sorted(each for each in near if not here.isdisjoint((each, *_with_a_gap(each)))))


def nearest(name: str, known: frozenset[str]) -> str | None:
    """Return the known name that differs by a letter or two; only names with the same first letters are compared."""
    alike = [each for each in _by_beginning(known).get(name[:4], ()) if abs(len(each) - len(name)) <= 1]
    from difflib import get_close_matches  # noqa: PLC0415 - few names are near to one by their beginning

    return next(iter(get_close_matches(name, alike, n=1, cutoff=0.92)), None)


@cache
def _by_beginning(known: frozenset[str]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for each in sorted(known):
        found.setdefault(each[:4], []).append(each)
    return found


@cache
def _in_order(known: frozenset[str]) -> tuple[list[str], list[str]]:
    """Return names sorted, and written backwards and sorted, once for all that are compared."""
    return sorted(known), sorted(each[::-1] for each in known)


def _beginning(start: str, names: list[str]) -> list[str]:
    """Return the names that begin so, among sorted ones."""
    return names[bisect_left(names, start) : bisect_left(names, f"{start}\U0010ffff")]


def _with_a_gap(name: str) -> Iterator[str]:
    """Yield a name with a gap in place of each letter, and with one between every two, but for digits."""
    for at in range(len(name) + 1):
        yield f"{name[:at]}*{name[at:]}"
        if at < len(name) and not name[at].isdigit():
            yield f"{name[:at]}*{name[at + 1 :]}"


def _swapped(name: str) -> Iterator[str]:
    for at, (one, two) in enumerate(pairwise(name)):
        yield f"{name[:at]}{two}{one}{name[at + 2 :]}"
