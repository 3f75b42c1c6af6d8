"""The brace expansion of a shell: ``lib{a,b}-dev`` is ``liba-dev libb-dev``.

https://www.gnu.org/software/bash/manual/html_node/Brace-Expansion.html
"""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_LIST = pattern(
    r"""'[^'\n]*' | (?<!\\)"(?:\\.|[^"\\\n])*"
      | (?<![\w$"'{}\\./@+=:~-]) (?P<before>[\w./@+=:~-]{0,80})
        \{(?P<among>[\w./@+:-]{0,80}(?:,[\w./@+:-]{0,80}){1,60})\}
        (?P<after>[\w./@+-]{0,80}) (?![\w"'{}$./@+-])""",
    re.VERBOSE,
)
"""What is quoted stays as it is, and so does a word of several lists or one with a variable in it. A list that is a
whole word or a value (``--env {ant,hopper}``, ``env={ant,hopper}``) is a choice that a page leaves to
its reader."""
_TAKES_MANY = pattern(r"\b(?:install|mkdir)\b")
"""What a page gives a list to; ``roslaunch demo {sim,real}.launch`` leaves a choice to its reader."""


def expanded(text: str) -> str:
    """Return a command that installs or makes folders with every list in braces written out, on the same line."""
    if "{" not in text or "," not in text or not _TAKES_MANY.search(text):
        return text
    return _LIST.sub(_written_out, text)


def _written_out(match: re.Match[str]) -> str:
    among, before = match["among"], match["before"]
    if among is None or before.endswith("=") or not (before or match["after"]):
        return match[0]
    return " ".join(f"{before}{each}{match['after']}" for each in among.split(","))
