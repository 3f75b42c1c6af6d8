"""Comments of XML, in files that may be broken: no parser reads them, and no end is looked for twice."""

from __future__ import annotations

from roslab.evidence.lex.lines import blank

_BEGIN, _END = "<!--", "-->"


def without_xml_comments(text: str, *, spaced: bool = False) -> str:
    """Return a text without what stands in ``<!-- … -->``; its lines keep their numbers.

    ``spaced``: with blanks in its place, so that what follows keeps its position too. A comment that is never closed
    stays.
    """
    start = text.find(_BEGIN)
    kept: list[str] = []
    read = 0
    while start >= 0 and (end := text.find(_END, start + len(_BEGIN))) >= 0:
        end += len(_END)
        left = blank(text[start:end]) if spaced else "\n" * text.count("\n", start, end)
        kept += (text[read:start], left)
        read = end
        start = text.find(_BEGIN, end)
    return "".join((*kept, text[read:]))
