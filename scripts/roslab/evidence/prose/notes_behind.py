"""Notes that Chinese and Japanese pages have behind a command in wide brackets: no shell takes them for a comment."""

from __future__ import annotations

from roslab.values.pattern import pattern

_LETTER = r"[\u3040-\u30ff\u3400-\u9fff\uac00-\ud7af]"
_OPEN, _CLOSE, _SEMICOLON = "\uff08", "\uff09", "\uff1b"
_STOPS = "\u3001\u3002\uff01\uff0c\uff1a\uff1f"
"""The wide forms of ``,``, ``.``, ``!``, ``:`` and ``?``. https://www.unicode.org/charts/PDF/UFF00.pdf (2026-11-29)"""
_NOTE = pattern(
    r"(?:"
    rf"(?<![=/]){_OPEN}(?=[^{_CLOSE}\n]{{0,200}}{_LETTER})"
    rf"(?![^{_CLOSE}\n]{{0,200}}{_CLOSE}[\w./-])|"  # no value, nor part of a name
    rf"[{_STOPS}]|{_SEMICOLON}(?!\s*[a-z./])|"
    rf"(?<=[A-Za-z0-9_.]),\s*(?={_LETTER})|"
    rf"(?<=\s)(?://+|-{{1,2}}>?|\u2014+|[<=]-|=>|[\u2190\u2192%])\s*(?={_LETTER})|"
    rf"(?:(?<=\.launch)|(?<=\.launch\.py))\s*(?:(?<=\s)(?={_LETTER})|{_OPEN})"  # a launch file takes no words
    r").*$"
)
_OPTION = pattern(r"(?:^|\s)--?[A-Za-z][\w-]*\s*$")
"""What waits for a value: what is in brackets behind it says which the reader gives."""
_WIDE = pattern(rf"[{_OPEN}{_SEMICOLON}{_STOPS}]|{_LETTER}")


def without_notes(text: str) -> str:
    """Return the text of a command without such a note at the end of a line, but for what is in quotes."""
    if text.isascii() or not _WIDE.search(text):
        return text
    return "\n".join(map(_without, text.split("\n")))


def _without(line: str) -> str:
    match = _NOTE.search(line)
    if match is None or any(line.count(quote, 0, match.start()) % 2 for quote in "\"'"):
        return line
    if match[0].startswith(_OPEN) and _OPTION.search(line, max(0, match.start() - 80), match.start()):
        return line
    return line[: match.start()].rstrip() + (" \\" if line.endswith("\\") else "")
