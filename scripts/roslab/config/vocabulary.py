"""The words of roslab.yaml as data: ``schema.json`` has every key and its grammar, ``words.json`` the words' meanings.

The reader takes its keys, its patterns and the text of its messages from the schema that editors use, so the two
always agree.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from functools import cache
from os.path import dirname
from typing import Any

from roslab.values.pattern import pattern

Schema = dict[str, Any]
"""A part of the JSON schema: a mapping of keywords."""
SCHEMA = f"{dirname(__file__)}/schema.json"  # noqa: PTH120 - `Path` would be slower
WORDS = f"{dirname(__file__)}/words.json"  # noqa: PTH120
_NEAR = 0.6
"""How similar two words must be, from 0 to 1, for one to be suggested for the other."""


@cache
def definition(name: str) -> Schema:
    """Return a definition of the schema, such as ``today`` or ``apt_item``."""
    found: Schema = _load(SCHEMA)["$defs"][name]
    return found


def resolve(schema: Schema) -> Schema:
    """Follow ``$ref``; keywords next to it have priority."""
    target = schema.get("$ref")
    if target is None:
        return schema
    return {**resolve(definition(target.rpartition("/")[2])), **{k: v for k, v in schema.items() if k != "$ref"}}


@cache
def compiled(source: str) -> re.Pattern[str]:
    """Compile a pattern of the schema, only once."""
    return pattern(source)


@cache
def rows(table: str) -> dict[str, Any]:
    """Return the rows of a table of ``words.json``."""
    found: dict[str, Any] = _load(WORDS)[table]["rows"]
    return found


def nearest(word: str, allowed: Iterable[str]) -> str | None:
    """Return the allowed word that was probably meant, ``None`` if none is similar.

    What stands before a ``/`` in both, ``linux/``, makes no two words similar.
    """
    import difflib  # noqa: PLC0415 - needed only where something is wrong

    asked, names = _plain(word), {_plain(name): name for name in allowed}
    before = asked[: asked.find("/") + 1]
    plain = {each.removeprefix(before): name for each, name in names.items() if each.startswith(before)}
    found = difflib.get_close_matches(asked.removeprefix(before), plain, n=1, cutoff=_NEAR)
    return plain[found[0]] if found else None


def _plain(word: str) -> str:
    return word.replace("-", "_").lower()


@cache
def _load(file: str) -> dict[str, Any]:
    with open(file, encoding="utf-8") as stream:  # noqa: PTH123 - as above
        data: dict[str, Any] = json.load(stream)
    return data
