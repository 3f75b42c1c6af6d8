"""Variables of CMake that a file sets once and never again.

What waits for a false one is as good as commented out; what waits for a true one is always built.
"""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

FALSE = frozenset({"0", "FALSE", "N", "NO", "OFF"})
TRUE = frozenset({"1", "ON", "TRUE", "Y", "YES"})
"""Both: https://cmake.org/cmake/help/latest/command/if.html"""
_COMMENT = pattern(r"#[^\n]*")
_CALL = pattern(r"(\w+)[ \t]*$")
_READING = frozenset(
    [
        *("if", "elseif", "else", "endif", "while", "message"),
        *("add_definitions", "add_compile_definitions", "target_compile_definitions", "add_compile_options"),
    ]
)
"""Calls that name a variable, or a macro called like it, and give no variable a value."""
MOST = 60
"""Most places of a name that are looked at."""


def set_once(text: str, name: str) -> bool:
    """Tell whether a file writes a variable once: by no second ``set``, and by no call that may give it a value.

    ``X_FOUND`` is what finding a package sets.
    """
    if name.upper().endswith("_FOUND") or not name.isidentifier():
        return False
    text = _COMMENT.sub("", text)
    places = [match.start() for match in re.finditer(rf"(?<![\w${{]){name}(?!\w)", text)]
    calls = [_call(text, place) for place in places[:MOST]]
    return (
        len(places) <= MOST and calls.count("set") == 1 and _READING.issuperset(each for each in calls if each != "set")
    )


def _call(text: str, place: int) -> str:
    """Return the name of the call that a place is an argument of."""
    depth = 0
    for position in range(place - 1, max(-1, place - 2_000), -1):
        if text[position] == ")":
            depth += 1
        elif text[position] == "(":
            if not depth and (match := _CALL.search(text, max(0, position - 80), position)):
                return match[1].lower() if match[1].upper() not in {"AND", "OR", "NOT"} else "if"
            depth = max(0, depth - 1)
    return ""
