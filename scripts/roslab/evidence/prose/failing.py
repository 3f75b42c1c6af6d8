"""Commands in a sentence about what to do where they fail: it names them, and has nobody start them."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_STARTS = pattern(r"(?:\$\s*)?(?:roslaunch|rosrun|ros2\s+(?:run|launch)|python[\d.]*|\.{1,2}/\S+)(?:\s|$)")
"""What is installed by a sentence about its failure was to be installed all the same."""
_IF = pattern(r"\b(?:if|when|whenever|in case|should)\s[^`.]{0,40}\Z", re.IGNORECASE)
_FAILS = pattern(
    r"[\s,]{0,3}(?:(?:still|ever|then|command)\s+){0,2}(?:"
    r"fails?|failed|crash\w*|hangs?|freezes?|dies|complains?|errors?|aborts?|segfaults?|times out|"
    r"(?:does|do|did|can|could|will|wo)\s*(?:not|n['\u2019]t)\b|cannot|"
    r"(?:says?|said|reports?|prints?|throws?|raises?|stops?|exits?)\b[^`.]{0,40}?"
    r"(?:$|[*_\"'\u201c]|\b(?:error|exception|no|not|fail\w*|warning)\b))",
    re.IGNORECASE,
)


def of_failure(line: str, start: int, end: int, command: str) -> bool:
    """Tell whether a line names the command at a place of it as one that fails: ``if `X` says *not found*``."""
    return bool(_STARTS.match(command) and _IF.search(line[:start]) and _FAILS.match(line, end))
