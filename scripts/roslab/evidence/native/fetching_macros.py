"""Macros of a project's own that fetch a library: ``add_dependency(NAME acme GIT_REPOSITORY https://… GIT_TAG v1)``."""

from __future__ import annotations

import re

from roslab.evidence.lex.cmake import Call
from roslab.values.pattern import pattern

_CALLED = pattern(
    r"^[ \t]{0,40}([A-Za-z]\w{1,60})[ \t]?\([^()\"]{0,400}?\bGIT_REPOSITORY\s{1,40}\"?https?:", re.MULTILINE
)
"""A call with the address of a repository; before that stand its name, versions and the like."""


def names(text: str, known: frozenset[str]) -> frozenset[str]:
    """Return names of calls with those of a text that have the address of a repository, in lower case."""
    if "GIT_REPOSITORY" not in text:
        return known
    return known | {match[1].lower() for match in _CALLED.finditer(text)}


def fetches(call: Call) -> bool:
    """Tell whether a call has the address of a repository."""
    return "GIT_REPOSITORY" in call.words
