"""Where the steps of a Dockerfile upgrade pip to whatever is the newest on the day of the build."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.shell import commands, logical_lines
from roslab.values.pattern import pattern

_PIP = pattern(r"(?:.*/)?pip(?:\d(?:\.\d+)?)?")
_PROGRAM = pattern(r"(?:.*/)?(?:pip|python|pypy)[\d.]*")
_UPGRADE = pattern(r"--upgrade|-[a-zA-Z]*U[a-zA-Z]*")


def newest_pips(steps: str, line: int) -> Iterator[int]:
    """Yield the line of each command that upgrades pip and names no bound: ``python3 -m pip install -U pip``.

    ``steps`` is the text of one RUN, which begins at ``line``.
    """
    for start, logical in logical_lines(steps, line):
        for command in commands(logical, start):
            before, asked, after = _parted(command.words)
            called = asked and bool(before) and bool(_PROGRAM.fullmatch(before[0])) and any(map(_PIP.fullmatch, before))
            if called and "pip" in after and any(map(_UPGRADE.fullmatch, after)):
                yield command.line


def _parted(words: tuple[str, ...]) -> tuple[tuple[str, ...], bool, tuple[str, ...]]:
    """Return what stands before ``install``, whether that is there, and what stands behind it."""
    if "install" not in words:
        return words, False, ()
    index = words.index("install")
    return words[:index], True, words[index + 1 :]
