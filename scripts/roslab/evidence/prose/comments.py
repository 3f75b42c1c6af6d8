"""Comments in a page, of HTML and of its blocks of code: what stands in them nobody is told."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.evidence.prose.headings import MAX_LINE, fence

_FENCE = "```"


def without_comments(text: str) -> str:
    """Return a page without the text in ``<!-- … -->``; its lines keep their numbers.

    One that is never closed stays, and so does ``<!--`` in a block of code or after a backquote: it is shown.
    """
    start = text.find("<!--")
    if start < 0:
        return text
    kept: list[str] = []
    read = fences = counted = 0
    while start >= 0:
        fences += text.count(_FENCE, counted, start)
        counted = start
        if fences % 2 or text[start - 1 : start] == "`":
            start = text.find("<!--", start + 4)
            continue
        end = text.find("-->", start + 2)  # `<!-->` is one, too
        if end < 0:
            break
        end += len("-->")
        kept += (text[read:start], "\n" * text.count("\n", start, end))
        read = counted = end
        start = text.find("<!--", end)
    return "".join((*kept, text[read:]))


def commented_out(lines: Sequence[str], command: re.Pattern[str]) -> frozenset[int]:
    """Return the numbers of the lines, from 1, in which a fenced block comments a command out.

    Only in a block that has a ``command`` which is not: else ``#`` is the prompt of root.
    """
    found: set[int] = set()
    block: list[int] | None = None
    for number, line in enumerate(lines, 1):
        if not fence(line):
            if block is not None:
                block.append(number)
            continue
        if block:
            marked = {each for each in block if lines[each - 1].lstrip().startswith("#")}
            marked = {each for each in marked if command.match(lines[each - 1][:MAX_LINE])}
            if marked and any(command.match(lines[each - 1][:MAX_LINE]) for each in block if each not in marked):
                found |= marked
        block = [] if block is None else None
    return frozenset(found)
