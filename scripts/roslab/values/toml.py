"""TOML by Python's own reader, or by its backport before Python 3.11."""

from __future__ import annotations

import sys
from typing import Any

from roslab.values.pattern import pattern, postponed

MAX_PARTS = 100
"""More parts than any person writes in a key, for which Python's reader takes time by their square."""
_LONG = pattern(rf"(?<![\w.-])(?:(?:[\w-]+|\"[^\"]*\"|'[^']*')[ \t]*\.[ \t]*){{{MAX_PARTS}}}")


def parsed(text: str) -> dict[str, Any]:
    """Return a document's tables.

    Raises ``ValueError`` if it is no TOML, or is nested more deeply than Python can follow, or than anybody writes.
    """
    for number, line in enumerate(text.split("\n"), 1):
        if line.count(".") >= MAX_PARTS and _LONG.search(line):
            raise ValueError(f"a key of more than {MAX_PARTS} parts (at line {number}, column 1)")
    with postponed():  # its patterns are kept as ours
        if sys.version_info >= (3, 11):  # imported here, since most repositories never need it
            import tomllib  # noqa: PLC0415
        else:
            import tomli as tomllib  # noqa: PLC0415
    try:
        return tomllib.loads(text)
    except RecursionError as error:
        raise ValueError("nested too deeply") from error
