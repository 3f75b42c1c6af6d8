"""A Dockerfile that needs no build context, so that its text alone makes its image."""

from __future__ import annotations

import re

from roslab.evidence.lex.dockerfile import instructions
from roslab.values.pattern import pattern

MOST = 16 * 1024
"""Most characters of such a file: a plan carries it."""
_FROM_A_STAGE = pattern(r"--from=\S|<<|^\s*https?://\S+\s+\S+\s*$")
_ESCAPE = pattern(r"^[ \t]*#[ \t]*escape[ \t]*=", re.IGNORECASE | re.MULTILINE)
_BOUND = pattern(r"--mount=(?!type=(?:cache|tmpfs|secret|ssh)\b)(?!\S*\bfrom=)")


def recipe(text: str) -> str | None:
    """Return the text of a Dockerfile, ``None`` where a step of it reads files of a build context or it is too long."""
    if len(text) > MOST or _ESCAPE.search(text):
        return None
    for instruction in instructions(text):
        if instruction.name in {"COPY", "ADD"} and not _FROM_A_STAGE.search(instruction.text):
            return None
        if instruction.name == "FROM" and "\n" in instruction.text:
            return None
        if instruction.name == "ONBUILD" or (instruction.name == "RUN" and _BOUND.search(instruction.text)):
            return None
    return text
