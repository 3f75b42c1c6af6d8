"""Shell scripts that stop where a variable is not set: where a simulator lies on the author's machine."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_NAME = r"([A-Z][A-Z0-9_]{2,60})"
_UNSET = pattern(
    rf"(?:\btest|\[\[?)[ \t]+(?:!|-z)[ \t]+[\"']?\$\{{?{_NAME}(?::?[-+]\w*)?\}}?[\"']?[ \t]*(?:\]\]?)?[ \t]*"
    r"(&&|;?\s*then\b)"
)
"""A test for a variable that is not set, and what begins after it: ``if [ -z "$NAME" ]; then``."""
_END = pattern(r"\b(?:fi|else|elif)\b")
_EXIT = pattern(r"\bexit\b(?![ \t]+0\b)")
_DEMANDED = pattern(rf"\$\{{{_NAME}:?\?")
"""``${NAME:?message}``."""
_SOURCED = pattern(r"^[ \t]*(?:source|\.)[ \t]+\S", re.MULTILINE)
_KNOWN = frozenset({"HOME", "USER", "DISPLAY", "PWD", "PATH", "SHELL", "ROS_DISTRO", "ROS_VERSION", "CONDA_PREFIX"})
"""Variables that an image sets itself, or that its container is given."""


def stops_unset(text: str) -> bool:
    """Tell whether a script ends where a variable is not set that neither it nor a file that it sources may set."""
    needed = [(match.start(), match[1]) for match in _UNSET.finditer(text) if _EXIT.search(_then(text, match))]
    needed += [(match.start(), match[1]) for match in _DEMANDED.finditer(text)]
    return any(name not in _KNOWN and not _may_be_set(text[:start], name) for start, name in needed)


def _then(text: str, match: re.Match[str]) -> str:
    """Return what is done where the variable is not set."""
    rest = text[match.end() :]
    return rest.partition("\n")[0] if match[2] == "&&" else _END.split(rest, maxsplit=1)[0]


def _may_be_set(before: str, name: str) -> bool:
    return bool(re.search(rf"\b{name}:?=|\bread\b[^\n]*\b{name}\b", before) or _SOURCED.search(before))
