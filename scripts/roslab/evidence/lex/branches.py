"""The branches of ``if`` and ``case`` in a script: only one of them runs."""

from __future__ import annotations

from roslab.values.pattern import pattern

Branch = tuple[int, int]
"""The number of the block, and that of the branch in it."""
_OPENS = pattern(r"\s*(?:if|case)\b")
_CLOSES = pattern(r"\s*(?:fi|esac)\b")
_NEXT = pattern(r"\s*(?:elif|else)\b")
_ONE_LINE = pattern(r"[;\s](?:fi|esac)\s*(?:[;#&|].*)?$")
_END = pattern(r";;&?\s*(?:#.*)?$")


def branches(text: str, first: int = 1) -> dict[int, Branch]:
    """Return the innermost branch of each line that stands in one; ``first`` is the number of the first line."""
    found: dict[int, Branch] = {}
    stack: list[Branch] = []
    blocks = 0
    for number, line in enumerate(text.split("\n"), first):
        if _OPENS.match(line):
            if not _ONE_LINE.search(line):
                blocks += 1
                stack.append((blocks, 0))
            continue
        if stack and _CLOSES.match(line):
            stack.pop()
            continue
        if stack and _NEXT.match(line):
            stack[-1] = (stack[-1][0], stack[-1][1] + 1)
            continue
        if stack:
            found[number] = stack[-1]
            if _END.search(line):
                stack[-1] = (stack[-1][0], stack[-1][1] + 1)
    return found
