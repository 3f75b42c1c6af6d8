"""The statements of Python code that import."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.values.pattern import pattern

IMPORT = pattern(
    r"^(?P<indent>[ \t]*)(?:import[ \t]+(?P<plain>[A-Za-z_][\w.]*(?:[ \t]+as[ \t]+\w+)?"
    r"(?:[ \t]*,[ \t]*[A-Za-z_][\w.]*(?:[ \t]+as[ \t]+\w+)?)*)(?=[ \t]*(?:[#;,\\\r]|$))"
    r"|from[ \t]+(?P<module>[A-Za-z_][\w.]*)[ \t]+import\b)",
    re.MULTILINE,
)


def statements(text: str) -> Iterator[re.Match[str]]:
    """Yield the statements that import; lines without that word need no pattern, which would read every one."""
    position = text.find("import")
    while position >= 0:
        start = text.rfind("\n", 0, position) + 1
        match = IMPORT.match(text, start)
        if match:
            yield match
        end = text.find("\n", match.end() if match else position)
        position = text.find("import", end) if end >= 0 else -1
