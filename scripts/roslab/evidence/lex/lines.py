"""Looking for what stands on one line, in long texts: only lines with a certain word are tried."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator


def lines_with(text: str, *words: str) -> Iterable[int]:
    """Return where each line with one of the words begins: words are found many times faster than a pattern."""
    if len(words) == 1:
        return _lines_with(text, words[0])
    return sorted({start for word in words for start in _lines_with(text, word)})


def _lines_with(text: str, word: str) -> Iterator[int]:
    position = text.find(word)
    while position >= 0:
        yield text.rfind("\n", 0, position) + 1
        end = text.find("\n", position)
        position = text.find(word, end) if end >= 0 else -1


def matching_lines(each: re.Pattern[str], text: str, *words: str) -> Iterator[re.Match[str]]:
    """Yield the matches of a pattern for the beginning of a line; every line where it matches has one of the words."""
    return (match for start in lines_with(text, *words) if (match := each.match(text, start)))


def first_line(each: re.Pattern[str], text: str, *words: str) -> re.Match[str] | None:
    """Return the first of these matches."""
    return next(matching_lines(each, text, *words), None)
