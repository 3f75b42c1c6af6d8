"""What a program of a page writes, and where."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_OUTPUT = pattern(
    r"-{0,2}(?:[\w.]*[._-])?(?:log|out|output|save|saving|result|record|run)s?(?:[._-]?(?:root|base))?"
    r"(?:[._-]?(?:dir|directory|path|folder|root))?",
    re.IGNORECASE,
)
"""The name of an option for it: ``--logdir``, ``--save_path``."""
_BELOW_HOME = pattern(r"~/(?=[\w.])")


def writes(option: str) -> bool:
    """Tell whether an option is named like one for what the program writes."""
    return bool(_OUTPUT.fullmatch(option))


def written_below(option: str, word: str) -> str:
    """Return an output folder in the reader's home, which the program makes, as one where the program is started.

    ``option`` is the word before it; other words stay as they are.
    """
    name, equals, value = word.rpartition("=")
    named = name if equals else option if option.startswith("-") else ""
    home = _BELOW_HOME.match(value)
    return f"{name}{equals}{value[home.end() :]}" if home and _OUTPUT.fullmatch(named) else word
