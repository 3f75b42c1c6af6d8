"""Variables that a block of a page sets and then uses: ``skip=0``, and below it ``python run.py $skip``."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_BLOCK = pattern(r"^```[^\n]*\n((?:(?!```)[^\n]*\n){1,200})", re.MULTILINE)
_ASSIGNED = pattern(
    r"[ \t]*(?:[$>][ \t]+)?([A-Za-z_]\w*)=(?:\"([^\"$`]*)\"|'([^'$`]*)'|([\w./:+-]+))[ \t]*;?[ \t]*(?:#.*)?"
)
"""A line that does nothing else."""
_OF_READER = pattern(r"(?:^|[/_-])(?:path|your?|my|xxx)(?:[/_-]|$)|distro", re.IGNORECASE)
"""What the reader writes in its place, or has in the environment."""


def with_values(page: str) -> str:
    """Return a page with the values of the variables that a block of code sets before the line."""
    return _BLOCK.sub(_filled, page) if "```" in page and "$" in page else page


def _filled(block: re.Match[str]) -> str:
    if "$" not in block[0] or "=" not in block[0]:
        return block[0]
    known: dict[str, str] = {}
    lines = []
    for line in block[0].split("\n"):
        if found := _ASSIGNED.fullmatch(line):
            value = next(part for part in found.groups()[1:] if part is not None)
            if not (_OF_READER.search(value) or _OF_READER.search(found[1])):
                known[found[1]] = value
        lines.append(line if found or not known else _with(line, known))
    return "\n".join(lines)


def _with(line: str, known: dict[str, str]) -> str:
    return re.sub(r"\$(?:\{(\w+)\}|(\w+))", lambda used: known.get(used[1] or used[2], used[0]), line)
