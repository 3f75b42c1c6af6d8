"""Failed builds in plain words: patterns of log lines with their cause and what to do."""

from __future__ import annotations

import re
from dataclasses import dataclass

from roslab.knowledge.table import rows

_STEP = re.compile(r"^#\d+ (?:\d+\.\d+ )?")
"""The number of BuildKit's step and its seconds, before what the step printed."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Diagnosis:
    """One known failure, as it stands in a log."""

    line: str
    cause: str
    fix: str


def diagnose(log: str) -> tuple[Diagnosis, ...]:
    """Return every known failure in a log, each once, in the order of the table: what is found first is rarer."""
    found: dict[tuple[str, str], Diagnosis] = {}
    for row in rows("failures"):
        for match in re.finditer(row["pattern"], log):
            start = log.rfind("\n", 0, match.start()) + 1
            end = log.find("\n", match.end())
            cause = row["cause"].format(*match.groups())
            line = _STEP.sub("", log[start : end if end >= 0 else len(log)].strip())
            found.setdefault((cause, row["fix"]), Diagnosis(line=line[:300], cause=cause, fix=row["fix"]))
    return tuple(found.values())
