"""Whether a shell can read a text at all, as far as its groups and blocks tell."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_OPAQUE = pattern(r"\\.|'[^']*'|\"(?:\\.|[^\"\\])*\"|\$\{[^}]*\}|(?<!\S)#[^\n]*", re.DOTALL)
"""What holds no word of the shell's own: escapes, quotes, variables, comments."""
_WORD = pattern(r"[^\s;|&()]+|[\n;|&()]")
_CLOSED_BY = {"fi": "if", "done": "do", "esac": "case", "}": "{"}
_OPENERS = frozenset(_CLOSED_BY.values())
_LEADING = frozenset({"then", "else", "elif", "while", "until", "!", "time"})
"""Words of the shell before a command."""


def unbalanced(text: str) -> str:
    """Return what no shell can read, ``""`` if nothing is found: a ``}``, ``fi``, ``done`` or ``esac`` too many.

    ``{curl`` without a blank opens no group, so that its ``}`` is one too many.
    """
    opened: list[str] = []
    first = True
    for match in _WORD.finditer(_OPAQUE.sub("x", text)):
        word = match[0]
        if word in "\n;|&()":
            first = True
        elif word == "{" or (first and word in _OPENERS):
            opened.append(word)
            first = word != "case"
        elif first and word in _CLOSED_BY:
            if not opened or opened.pop() != _CLOSED_BY[word]:
                return f"`{word}` closes nothing"
        else:
            first = first and word in _LEADING
    return ""
