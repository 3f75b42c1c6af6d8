"""Lines of Python that run whatever the arguments are, as their indentation shows."""

from __future__ import annotations

from roslab.values.pattern import pattern

_DECIDES = pattern(r"(?:try|if|elif|else|except|for|while)\b")
_HEAD = pattern(r"(?:async[ \t]+)?(?:def|class)\b")


def always_run(text: str, at: int) -> bool:
    """Tell whether no condition, loop or attempt is around a line of Python: none before the head of its function.

    ``at`` is a place on the line.
    """
    begin = text.rfind("\n", 0, at) + 1
    depth = len(text) - begin - len(text[begin:].lstrip(" \t"))
    for line in reversed(text[:begin].split("\n")):
        bare = line.lstrip()
        indent = len(line) - len(bare)
        if not bare or bare.startswith(("#", ")")) or indent >= depth:
            continue
        if _HEAD.match(bare):
            return True
        if _DECIDES.match(bare):
            return bare.startswith("if __name__")
        depth = indent
    return True
