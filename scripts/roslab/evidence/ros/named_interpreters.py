"""Pythons of the author's machine that launch files name: nodes, and programs beside them, are started by these."""

from __future__ import annotations

from roslab.values.home import HOME
from roslab.values.pattern import pattern

_NAMED = pattern(
    rf"(?<![\w./~$}})-])/(?!usr/|s?bin/|opt/(?:conda|ros)/|{HOME[1:]}/)"
    r"(?:(?!\.\.?/)[\w.+@-]{1,80}/){0,12}bin/python[\d.]{0,9}(?![\w./-])"
)
"""The path of one in no folder that the image has: of an environment, or of a conda of the author's."""


def named_interpreters(text: str) -> tuple[tuple[str, int], ...]:
    """Return the paths that a launch file without its remarks names, each once with its first line.

    ``launch-prefix``, the default of the argument that it takes, a command of Python's ``ExecuteProcess``: wherever one
    stands, something is started by it.
    """
    if "bin/python" not in text:
        return ()
    found: dict[str, int] = {}
    for match in _NAMED.finditer(text):
        found.setdefault(match[0].rstrip("."), text.count("\n", 0, match.start()) + 1)
    return tuple(found.items())
