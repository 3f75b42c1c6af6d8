"""The files by which find_package finds what a CMakeLists.txt installs: ``gripper-config.cmake``."""

from __future__ import annotations

from roslab.evidence.lex.cmake import Call
from roslab.values.pattern import pattern

_CONFIG = pattern(r"(?:^|/)([A-Za-z][\w.+]*(?:-[\w.+]+)*?)(?:-config|Config)(?:\.cmake)?$")
"""https://cmake.org/cmake/help/latest/command/find_package.html, read 2026-11-26."""


def configs(call: Call) -> dict[str, None]:
    """Return the names of packages for which a call installs such a file: a file of its own, or that of an export."""
    if call.name != "install" or call.in_function or call.words[:1] not in {("FILES",), ("EXPORT",)}:
        return {}
    return {match[1]: None for word in call.words[1:] if (match := _CONFIG.search(word))}
