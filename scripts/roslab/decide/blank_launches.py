"""Launch files whose name has a blank on a page, ``mapping_XXX.launch``: any of those that fit is meant."""

from __future__ import annotations

import re
from collections.abc import Mapping

from roslab.values.pattern import pattern

_BLANK = pattern(r"[xX]{2,}|(?<![A-Za-z])[A-Z]{3,}(?:_[A-Z]+)*(?![A-Za-z])")
LAUNCH = pattern(r"\.launch(?:\.(?:py|xml|ya?ml))?$|_launch\.(?:py|xml|ya?ml)$")
"""How the name of a launch file ends."""


def with_a_launch_file(argv: tuple[str, ...], launched: Mapping[str, frozenset[str]]) -> tuple[str, ...]:
    """Return a command with the first launch file, by its name, that fits the blank in it; others as they are.

    ``launched`` are the launch files of each package. What is left of the name without the blank has to tell something.
    """
    at = 2 if argv[:1] == ("roslaunch",) else 3 if argv[:2] == ("ros2", "launch") else 0
    if not at or len(argv) <= at or argv[at] in (names := launched.get(argv[at - 1], frozenset())):
        return argv
    said = LAUNCH.sub("", argv[at])
    parts = _BLANK.split(said)
    if len(parts) < 2 or not any(part.strip("_-.") for part in parts):
        return argv
    meant = re.compile(r"\w+".join(map(re.escape, parts)) + re.escape(argv[at][len(said) :]))
    fitting = sorted(name for name in names if meant.fullmatch(name))
    return (*argv[:at], fitting[0], *argv[at + 1 :]) if fitting else argv
