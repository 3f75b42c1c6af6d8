"""Comments of C and C++, in files that are not parsed: no end is looked for twice."""

from __future__ import annotations

from roslab.evidence.lex.lines import blank, end_of_line
from roslab.values.pattern import pattern

_OPENS = pattern(r"(?<!:)//|/\*")
"""What begins a comment: no address does, as ``package://arm_description/urdf/arm.urdf``."""


def without_c_comments(text: str) -> str:
    """Return code with blanks for its comments, so that the rest keeps its place.

    What opens one that nothing closes, as a path in quotation marks, is none.
    """
    last = text.rfind("*/")
    kept: list[str] = []
    at = begin = 0
    while match := _OPENS.search(text, at):
        start = match.start()
        if match[0] == "/*" and start + 2 > last:
            at = start + 2
            continue
        at = end_of_line(text, start) if match[0] == "//" else text.find("*/", start + 2) + 2
        kept += (text[begin:start], blank(text[start:at]))
        begin = at
    return "".join((*kept, text[begin:]))
