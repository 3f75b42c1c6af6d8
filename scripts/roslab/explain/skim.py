"""Leaves lines out of very large logs, a chunk at a time, where nothing failed.

A log of 100 MB has more than a million lines; looking at each of them takes longer than the person waits. Searching a
whole chunk for a word is a hundred times as fast as searching each of its lines.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.values.pattern import pattern

MARKS = (
    "rror", "ERR", "atal", "FATAL", "ailed", "ailure", "AIL", "ound", "No such", "annot", "an't", "nable", "ndefined",
    "ould not", "enied", "illed", "raceback", "xpired", "XPIRED", "404", "403", "equire", "E: ", "W: ", "nvalid",
    "issing", "xception", "bort", "nsupp", "efused", "timed", "no longer", "space",
)  # fmt: skip
"""Parts of words; every line that says why something failed has at least one of them."""


def is_marked(text: str) -> bool:
    """Return whether a line might say why something failed; a plain loop is fast enough for a million lines."""
    for mark in MARKS:  # noqa: SIM110 - `any` with a generator takes three times as long
        if mark in text:
            return True
    return False


_FAILED = (" ERROR: ", "rror: building at STEP", "non-zero code")
"""What builders write where a step failed; the lines before it are all kept."""
_SAID = (
    "error", "err!", "fail", "fatal", "not found", "no such", "cannot", "could not", "undefined", "unable", "denied",
    "killed", "exception",
)  # fmt: skip
"""Fewer words than ``MARKS``, for the inside of very large logs: each takes a millisecond for a million characters."""
_FRAME = pattern(r"\n(?=#\d{1,6} \D|S(?:tep|TEP) \d| > |\{|-----)")
"""The beginning of a line that belongs to no step's output."""
_END = 300
"""Number of lines at the end of a chunk that are kept."""


def with_quiet(chunks: Iterator[str], beginning: int) -> Iterator[tuple[str, bool]]:
    """Yield each chunk, and whether lines of it may be left out.

    Every line is kept of the first ``beginning`` chunks and the last two, of each chunk in which a step failed, and of
    the one before it.
    """
    held: list[tuple[str, bool]] = []
    for at, text in enumerate(chunks):
        quiet = at >= beginning and not any(word in text for word in _FAILED)
        if not quiet and held:
            held[-1] = (held[-1][0], False)
        held.append((text, quiet))
        if len(held) > 2:
            yield held.pop(0)
    yield from ((text, False) for text, _ in held)


def kept(text: str) -> list[tuple[int, str]] | None:
    """Return the lines of a chunk that matter, each with its number from 1; ``None`` if most of them do."""
    low = text.lower()
    if len(low) != len(text):  # a few letters become two in lower case, and positions would no longer fit
        low = text
    most = text.count("\n") // 3
    starts = {found.end() for found in _FRAME.finditer(text)}
    for word in _SAID:
        at = low.find(word)
        while at >= 0:
            starts.add(text.rfind("\n", 0, at) + 1)
            end = text.find("\n", at)
            at = low.find(word, end) if end >= 0 else -1
        if len(starts) > most:
            return None
    end = len(text)
    for _ in range(_END):
        end = max(text.rfind("\n", 0, end), 0)
    found, number, before = [], 1, 0
    for start in sorted(start for start in starts if start < end):
        number += text.count("\n", before, start)
        found.append((number, text[start : text.find("\n", start)]))
        before = start
    tail = text[end:].removeprefix("\n").removesuffix("\n").split("\n")
    number += text.count("\n", before, end) + (text[end : end + 1] == "\n")
    return found + list(enumerate(tail, number))
