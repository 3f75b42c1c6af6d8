"""Blocks of HTML in a page that show code: ``<pre>``, as Markdown shows it too."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_FENCE = "```"
_BLOCK = pattern(
    r"^[ \t]{0,8}<pre\b[^>\n]{0,80}>(\s{0,9}<code\b[^>\n]{0,80}>)?"
    r"((?:(?!</?pre\b)[\s\S]){0,8000}?)(</code>\s{0,9})?</pre>",
    re.IGNORECASE | re.MULTILINE,
)
_TAG = pattern(r"</?(?:code|b|i|em|strong|span|font)\b[^>\n]{0,80}>", re.IGNORECASE)


def as_markdown(text: str) -> str:
    """Return a page with its blocks of ``<pre>`` as Markdown writes them; its lines keep their numbers.

    One whose tags have lines of their own is fenced, of another one each line is indented.
    """
    return _BLOCK.sub(_written, text) if "<pre" in text.lower() else text


def _written(match: re.Match[str]) -> str:
    from html import unescape  # noqa: PLC0415 - its table of names is long, and few pages have such a block

    before = match.string[: match.start()]
    if before.count(_FENCE) % 2:
        return match[0]
    around = ["\n" * (part or "").count("\n") for part in match.group(1, 3)]
    code = unescape(_TAG.sub("", match[2])).join(around)
    if code[:1] == "\n" and code.rstrip(" \t")[-1:] == "\n":
        return f"{_FENCE}{code}{_FENCE}"
    return "\n".join(f"    {line}" if line.strip() else "" for line in code.split("\n"))
