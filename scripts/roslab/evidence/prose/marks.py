"""Marks of Markdown in a line that shows a command: a page's, not the shell's."""

from __future__ import annotations

from roslab.values.pattern import pattern

_BOLD = pattern(r"(?<![\w/*])\*\*(?=[^\s*/])([^*\n]{0,300}?[^\s*/])\*\*(?![\w/*])")
_WHOLE = pattern(r"(\s{0,12})(\*)(?=[A-Za-z./])([^*\n]{1,300}[\w./\"'])\2\s{0,12}")
_END = pattern(r"(?:\s{0,4}(?:`{2,}|\\`)|(?<=[\w.\"'-])\*\*)\s{0,12}$")


def without_marks(line: str) -> str:
    r"""Return a line without what makes it, or a word of it, bold or slanted, and without marks of code at its end.

    What a shell means by such signs stays: ``data/*``, ``src/**/a.py``, ``\\`date\\```.
    """
    if "*" in line:
        whole = _WHOLE.fullmatch(line)
        line = _BOLD.sub(r"\1", f"{whole[1]}{whole[3]}" if whole else line)
    return _END.sub("", line) if "`" in line or "**" in line else line
