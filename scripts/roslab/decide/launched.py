"""The launcher without which a program of Python stops, before the command that a page starts with it."""

from __future__ import annotations

from roslab.decide.candidate import Candidate, is_python
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def launched(candidate: Candidate, evidence: Evidence) -> Candidate:
    """Return a command with its launcher, which starts one process; as it is where it needs none."""
    found = (m for m in evidence.mentions if m.topic == "launcher")
    same = (m for m in found if (m.file, m.line) == (candidate.file, candidate.line))
    words = next((tuple(m.text.split()) for m in same if not {*m.files}.isdisjoint(candidate.argv)), ())
    if not words or not is_python(candidate):
        return candidate
    words = (candidate.argv[0], *words[1:]) if words[0].startswith("python") else words
    return replace(candidate, argv=(*words, *candidate.argv[1:]))
