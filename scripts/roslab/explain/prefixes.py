"""Removes what CI services write before each line of a log."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable

from roslab.values.pattern import pattern

_SAMPLE = 400
"""Number of lines that are examined to find the prefix of all lines."""
_PREFIXES: dict[str, re.Pattern[str]] = {
    # gh run view --log: job, step and time, with tabs between; https://cli.github.com/manual/gh_run_view
    "gh": pattern(r"[^\t\n]{1,200}\t[^\t\n]{1,200}\t\ufeff?\d{4}-\d\d-\d\dT[\d:.]{8,20}Z ?"),
    # GitHub's raw logs; GitLab's with the number of the stream: https://docs.gitlab.com/ci/jobs/job_logs/
    "time": pattern(r"\ufeff?\d{4}-\d\d-\d\dT[\d:.]{8,20}Z (?:\d\d[OE][+ ]?)?"),
    # a part of what BuildKit repeats: the seconds that each line took
    "seconds": pattern(r"\d{1,5}\.\d{2,3}(?: |$)"),
    # docker compose: the service and a bar
    "compose": pattern(r"[a-zA-Z][\w.-]{0,60}[_-]\d{1,3} {1,20}\| "),
    # docker compose and Jenkins
    "clock": pattern(r"\[?\d{4}-\d\d-\d\d[T ]\d\d:\d\d:\d\d(?:[.,]\d{1,9})?(?:Z|[+-]\d\d:?\d\d)?\]? "),
    # act: [workflow/job], and a bar before what a step printed; a clock in brackets would be taken for it
    "act": pattern(r"\[[^\]\n]{1,200}\] {1,3}(?:\| ?)?"),
}
_NODE = pattern(r"^\[[\w.+-]{1,100}-\d{1,4}\] ", re.MULTILINE)
"""What launch of ROS 2 writes before each line of a node; it says when it starts one."""
_STARTED = "]: process started with pid ["
_SECTION = pattern(r"^section_(?:start|end):\d{1,12}:[\w.-]{1,100}(?:\[[^\]\n]{0,100}\])?\s?", re.MULTILINE)


def stripper(text: str) -> Callable[[str], str] | None:
    """Return a function that removes the prefix that most lines of a text have; ``None`` if they have none."""
    filled = [line for line in text.split("\n", _SAMPLE)[:_SAMPLE] if line.strip()]
    votes = Counter(name for line in filled for name, prefix in _PREFIXES.items() if prefix.match(line))
    chosen = next((_PREFIXES[name] for name in _PREFIXES if votes[name] > 0.6 * len(filled)), None)
    section = any("section_start:" in line for line in filled)
    launched = _STARTED in text
    if chosen is None and not section and not launched:
        return None
    prefix = re.compile(f"^(?:{chosen.pattern})", re.MULTILINE) if chosen is not None else None

    def strip(text: str) -> str:
        plain = prefix.sub("", text) if prefix is not None else text
        plain = _NODE.sub("", plain) if launched else plain
        return _SECTION.sub("", plain) if "section_" in plain else plain

    return strip
