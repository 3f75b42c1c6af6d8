"""Usage texts that go on below their command without a backslash: ``demo.py`` and, below it, ``[-h] --map MAP``."""

from __future__ import annotations

from roslab.values.pattern import pattern

MOST = 40
"""Most lines of one text."""
_GOES_ON = pattern(r"[ \t]+(?:\[|--?[A-Za-z][\w-]*(?:[ =][A-Z][A-Z0-9_]*\b|[ =]\{|$)|[A-Z][A-Z0-9_]+(?:[ \t]|$)|\{)")
"""A line of options with what they stand for in capitals, or of what may be left out, in brackets."""
_BRACKET = pattern(r"[ \t]+.*\[(?:-|[A-Z])")
_COMMAND = pattern(r"\s*(?:[$>]\s+)?(?:usage:\s*)?[\w./~-]+\s+\S*[A-Za-z]", 2)


def with_synopses(lines: list[str]) -> list[str]:
    """Return the lines with a backslash wherever such a text goes on, so that it is one command with its blanks."""
    found = list(lines)
    index = 0
    while index < len(lines) - 1:
        end = index + 1
        while end < len(lines) and end - index <= MOST and _GOES_ON.match(lines[end]):
            end += 1
        text = lines[index + 1 : end]
        told = any(map(_BRACKET.match, text)) and _COMMAND.match(lines[index]) and not lines[index].endswith("\\")
        if told and _depth(lines[index]) < min(map(_depth, text)):
            found[index : end - 1] = [f"{line.rstrip()} \\" for line in lines[index : end - 1]]
        index = max(end - 1, index + 1) if text else index + 1
    return found


def _depth(line: str) -> int:
    return len(line) - len(line.lstrip())
