"""What the steps of a Dockerfile do to pip, and to what it builds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from roslab.evidence.lex.shell import commands, logical_lines
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from roslab.evidence.lex.dockerfile import Instruction

_PIP = pattern(r"(?:.*/)?pip(?:\d(?:\.\d+)?)?")
_PROGRAM = pattern(r"(?:.*/)?(?:pip|python|pypy)[\d.]*")
_UPGRADE = pattern(r"--upgrade|-[a-zA-Z]*U[a-zA-Z]*")
MAY_CALL_PIP = pattern(r"\bpip|\bconda\b|\bmamba\b|\bsetup\.py\b|\.sh\b")
"""As ``shell-as-of`` knows a step that may call pip; a test holds them to each other."""
_CHANGES = pattern(r"\bsed\b[^\n]*\bsetup\.py\b|\bis_available\b|\bpatch\b|\bgit\s+(?:apply|am)\b")


def newest_pips(written: Sequence[Instruction], images: Sequence[tuple[int, str]]) -> Iterator[tuple[str, int]]:
    """Yield each image in which pip is upgraded without a bound, as by ``pip install -U pip``, with the line.

    ``images``: the line of each FROM, and the image that its stage starts from.
    """
    for step in written:
        if step.name == "RUN" and "pip" in step.text:
            image = image_at(step.line, images)
            yield from ((image, line) for line in _upgrades(step.steps, step.line) if image)


def image_at(line: int, images: Sequence[tuple[int, str]]) -> str:
    """Return the image that the stage of a line starts from, ``""`` before the first FROM."""
    return next((image for first, image in reversed(images) if first < line), "")


def changes_setup(written: Sequence[Instruction]) -> bool:
    """Tell whether a step may change what a setup.py asks for."""
    return any(step.name == "RUN" and _CHANGES.search(step.text) for step in written)


def own_shell(written: Sequence[Instruction]) -> bool:
    """Tell whether it names the shell of its steps, or has that shell start a script or pip in the container.

    The shell also starts a CMD, an ENTRYPOINT or a HEALTHCHECK that is no list of words
    (https://docs.docker.com/reference/dockerfile/#shell-and-exec-form, 2026-11-27).
    """
    started = (step.text for step in written if step.name in {"CMD", "ENTRYPOINT", "HEALTHCHECK"})
    shelled = (text for text in started if not text.lstrip().startswith("["))
    return any(step.name == "SHELL" for step in written) or any(map(MAY_CALL_PIP.search, shelled))


def _upgrades(steps: str, first: int) -> Iterator[int]:
    for start, logical in logical_lines(steps, first):
        for command in commands(logical, start):
            before, after = _parted(command.words)
            called = bool(before) and bool(_PROGRAM.fullmatch(before[0])) and any(map(_PIP.fullmatch, before))
            if called and "pip" in after and any(map(_UPGRADE.fullmatch, after)):
                yield command.line


def _parted(words: tuple[str, ...]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return what stands before ``install`` and what stands behind it."""
    index = words.index("install") if "install" in words else len(words)
    return words[:index], words[index + 1 :]
