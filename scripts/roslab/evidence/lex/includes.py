"""The lines of C and C++ that include headers."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from roslab.values.pattern import pattern

_INCLUDE = pattern(r"#[ \t]*include[ \t]*[<\"]([\w./+-]+)[>\"]")
"""It begins with a letter of its own, which is found much faster than the beginning of a line."""


def includes(text: str, passed_over: Collection[str] = ()) -> Iterator[re.Match[str]]:
    """Yield the includes of a file but those of some headers, the name in the first group; behind ``//`` is none."""
    for match in _INCLUDE.finditer(text):
        if match[1] in passed_over:
            continue
        if not text[text.rfind("\n", 0, match.start()) + 1 : match.start()].strip(" \t"):
            yield match
