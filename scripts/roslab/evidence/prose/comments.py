"""Comments of HTML in a page: what stands in them nobody is told."""

from __future__ import annotations

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
