"""The release that a page means where it names several (``PyTorch 0.7.0/1.6.0``), or one that never was."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.prose import mentions
from roslab.knowledge.frameworks import Framework, framework, never_released
from roslab.values.pattern import pattern

_OR = pattern(r"\s*(?:/|\bor\b)\s*v?(\d{1,2}(?:\.\d{1,3}){1,2})(?![\w.]*\d)")
"""Another release right behind one."""
_FITS = ("python", "cuda")
"""What a release has wheels for."""


def release_of(package: str, number: str, text: str, end: int) -> str | None:
    """Return the release that ``text`` gives a package with a number that ends at ``end``, ``None`` for none.

    Of several, the first that there is and that has wheels for the Python and the CUDA that the text names.
    """
    named = (number, *_others(text, end))
    there = [each for each in named if not never_released(package, each)]
    if len(there) < 2:
        return next(iter(there), None)
    known = {each: row for each in there if (row := framework(package, each))}
    versions = {topic: {m.value for m in mentions.read(text, "", "readme") if m.topic == topic} for topic in _FITS}
    fitting = (each for each, row in known.items() if _fits(row, versions))
    return next(fitting, there[0])


def _others(text: str, end: int) -> Iterator[str]:
    while match := _OR.match(text, end):
        yield match[1]
        end = match.end()


def _fits(row: Framework, versions: dict[str, set[str]]) -> bool:
    """Tell whether a release has wheels for what a text names; what it does not name fits."""
    pythons, cudas = (versions[topic] for topic in _FITS)
    runs = not pythons or any(map(row.runs_with, pythons))
    return runs and (not cudas or not cudas.isdisjoint(row.cuda))
