"""The conditions around a line of Python, in its function and outside of it, as the indentation shows."""

from __future__ import annotations

from roslab.values.pattern import pattern

_CONDITION = pattern(r"(?:if|elif|else|try|except|while|case)\b(?!\s+__name__\s*==)")
_INDENT = pattern(r"[ \t]*")


def conditional(text: str, start: int) -> bool:
    """Tell whether a line is reached only under a condition, by what stands before it with less indentation."""
    least = depth(text, start)
    for line in reversed(text[:start].split("\n")[:-1]):
        said = line.strip()
        if least and said and not said.startswith("#") and depth(line) < least:
            least = depth(line)
            if _CONDITION.match(said):
                return True
    return False


def depth(text: str, start: int = 0) -> int:
    """Return by how many columns a line is indented that begins at ``start``."""
    found = _INDENT.match(text, start)
    return len(found[0].expandtabs()) if found else 0
