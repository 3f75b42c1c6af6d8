"""A shell script that is the same for every repository except for a head of commented, quoted assignments.

The script is a separate file with a complete head, so that it can be read, run and linted unchanged.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.render import quote

HEAD = "# ---- this repository"
BODY = "# ---- the same for every repository"


def script(name: str, values: Mapping[str, str | Sequence[Sequence[str]]]) -> str:
    """Return the text of the script ``name`` with the given values in its head.

    A text becomes a variable; rows of words become one array, with a row on each line. Raises ``ConfigurationError``
    for a value that cannot be quoted, ``KeyError`` if the names differ from those in the script's own head.
    """
    lines = Path(__file__).with_name(name).read_text(encoding="utf-8").splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith(HEAD)) + 1
    last = next(i for i, line in enumerate(lines) if line.startswith(BODY))
    names = {line: line.partition("=")[0] for line in lines[first:last] if not line.startswith("#")}
    if {*names.values()} != {*values}:
        raise KeyError(*sorted({*names.values()} ^ {*values}))
    head = [f"{names[line]}={_value(values[names[line]])}" if line in names else line for line in lines[first:last]]
    return "\n".join((*lines[:first], *head, *lines[last:])) + "\n"


def _value(value: str | Sequence[Sequence[str]]) -> str:
    if isinstance(value, str):
        return quote.shell(value)
    if not value:
        return "()"
    return "(\n" + "".join(f"  {' '.join(quote.shell(word) for word in row)}\n" for row in value) + ")"
