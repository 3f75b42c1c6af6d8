"""The words of a command as one text: a blank separates two of them, and one inside a quoted word has a sign."""

from __future__ import annotations

import shlex
from collections.abc import Iterable

BLANK = "\N{OPEN BOX}"
"""Stands for a blank inside a word."""


def joined(words: Iterable[str]) -> str:
    """Return the words as one text, which ``split`` parts again where they were."""
    return " ".join(BLANK.join(word.split(" ")) for word in words)


def written(word: str) -> str:
    """Return a word of such a text as the shell reads it."""
    return word.replace(BLANK, " ")


def line_of(command: str | Iterable[str]) -> str:
    """Return a command as a shell reads it: one for the shell as it is, words with the quotes that they need."""
    return command if isinstance(command, str) else shlex.join(command)
