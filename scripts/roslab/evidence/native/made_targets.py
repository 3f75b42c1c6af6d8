"""The targets of CMake that a CMakeLists.txt makes."""

from __future__ import annotations

from roslab.evidence.lex.cmake import Call
from roslab.values.pattern import pattern

TARGET = pattern(r"[A-Za-z][\w.+-]*$")


def target(call: Call) -> dict[str, None]:
    """Return the target that a call for a program or library makes whatever the conditions are."""
    words = () if call.conditions or call.in_function or "IMPORTED" in call.words else call.words[:1]
    return dict.fromkeys(word for word in words if TARGET.match(word))
