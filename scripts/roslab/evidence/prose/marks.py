"""Marks of Markdown in a line that shows a command: a page's, not the shell's."""

from __future__ import annotations

from roslab.values.pattern import pattern

_BOLD = pattern(r"(?<![\w/*])\*\*(?=[^\s*/])([^*\n]{0,300}?[^\s*/])\*\*(?![\w/*])")
_WHOLE = pattern(r"(\s{0,12})(\*)(?=[A-Za-z./])([^*\n]{1,300}[\w./\"'])\2\s{0,12}")
_OPEN = pattern(r"(?<=[\w.\"'-])\*\*\s{0,12}$")
"""The end of what is bold from a place before the command on."""
_END = pattern(r"\s{0,4}(?:`{2,}|\\`)\s{0,12}$")


def without_marks(line: str, *, fenced: bool) -> str:
    """Return a line without what makes it, or a word of it, bold or slanted; of a block also without marks of code.

    Those are at its end. What a shell means by such signs stays: ``data/*``, ``src/**/a.py``.
    """
    if "*" in line:
        whole = _WHOLE.fullmatch(line)
        line = _BOLD.sub(r"\1", f"{whole[1]}{whole[3]}" if whole else line)
        line = _OPEN.sub("", line)
    return _END.sub("", line) if fenced and "`" in line else line
