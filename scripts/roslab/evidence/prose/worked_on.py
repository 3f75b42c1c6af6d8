"""The days that a repository gives for itself: of its commit, and of its citation file."""

from __future__ import annotations

import re

from roslab.evidence.facts import Mention
from roslab.evidence.ros import commit_date
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_FILES = ("CITATION.cff", "CITATION.bib", "CITATION")
_RELEASED = pattern(r"^\s*date-released:\s*['\"]?(\d{4}-\d{2}-\d{2})", re.MULTILINE)
_YEAR = pattern(r"^\s*year\s*[:=]\s*[{\"']*(\d{4})\b", re.MULTILINE | re.IGNORECASE)


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return the day of the checkout's commit, then those of citation files; a year alone is its last day.

    https://github.com/citation-file-format/citation-file-format/blob/main/schema-guide.md
    """
    found = list(commit_date.read(repository))
    for name in _FILES:
        text = repository.read(name) if repository.has(name) else ""
        match = _RELEASED.search(text) or _YEAR.search(text)
        if match:
            day = match[1] if "-" in match[1] else f"{match[1]}-12-31"
            line = text.count("\n", 0, match.start(1)) + 1
            found.append(Mention(topic="date", value=day, source="readme", file=name, line=line, text=match[0].strip()))
    return tuple(found)
