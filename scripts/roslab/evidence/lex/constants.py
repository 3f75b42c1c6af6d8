"""Variables of CMake that a file sets once and never again, and those that nothing in it sets.

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
_FINDS = pattern(r"(?i)\b(?:find_package|pkg_check_modules|pkg_search_module)[ \t]*\(\s{0,40}(\w+)")
"""What sets ``X_FOUND``, ``X_LIBRARIES`` and other variables that begin like its first word."""
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
    places = _places(text, name)
    calls = [_call(text, place) for place in places[:MOST]]
    return (
        len(places) <= MOST and calls.count("set") == 1 and _READING.issuperset(each for each in calls if each != "set")
    )


def may_be_set(text: str, name: str, *, in_cache: bool = True) -> bool:
    """Tell whether a file may give a variable a value, itself or by finding a package.

    Not ``in_cache``: other than by ``set(X … CACHE …)``, over which ``-DX=…`` wins.
    """
    text = _COMMENT.sub("", text)
    if any(name.lower().startswith(f"{match[1].lower()}_") for match in _FINDS.finditer(text)):
        return True
    places = _places(text, name)
    given = (place for place in places[:MOST] if _call(text, place) not in _READING)
    return len(places) > MOST or any(in_cache or not _of_cache(text, place) for place in given)


def _of_cache(text: str, place: int) -> bool:
    words = text[place : place + 2_000].partition(")")[0].split()
    return "CACHE" in words and _call(text, place) == "set"


def _places(text: str, name: str) -> list[int]:
    return [match.start() for match in re.finditer(rf"(?<![\w${{]){name}(?!\w)", text)]


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
