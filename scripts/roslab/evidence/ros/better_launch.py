"""Launch files in Python that are written with better_launch, which describes nothing and starts it at once.

https://github.com/dfki-ric/better_launch, 2026-11-26: ``bl.node(PACKAGE, PROGRAM)``, ``bl.include(PACKAGE, FILE)``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.lex.always_run import always_run
from roslab.evidence.lex.lines import matches_at
from roslab.values.pattern import pattern

_CALL = pattern(
    r"\.(?:node|include|component|find)\(\s*[\"']([a-z][a-z0-9_-]{1,60})[\"']\s*,\s*[\"']([\w./-]{0,80})[\"']"
)
_CALLS = (".node(", ".include(", ".component(", ".find(")
"""What its matches begin with."""


def is_launch_file(name: str, text: str) -> bool:
    """Tell whether a file in Python is one that ``ros2 launch`` starts: it makes the description, or has it made.

    Another library may do that, so that a file called ``x.launch.py`` is one where it imports anything.
    """
    return "LaunchDescription" in text or (name.endswith(".launch.py") and "import" in text)


def named(text: str) -> Iterator[tuple[re.Match[str], bool]]:
    """Yield each call with a package and what is meant of it, and whether a condition of Python decides about it."""
    if "better_launch" in text:
        for match in matches_at(_CALL, text, *_CALLS):
            yield match, not always_run(text, match.start())
