"""Whether the reader opens a notebook, for which its server has to be in the image."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate
from roslab.decide.candidates import of_notebooks
from roslab.decide.first_command import first_of
from roslab.decide.meant_commands import pointed_at
from roslab.decide.written_commands import written
from roslab.evidence.facts import Evidence, Mention


def opened(evidence: Evidence, kind: Kind) -> Mention | Candidate | None:
    """Return where a page opens a notebook, or names one and runs nothing, or the first of a tree of notebooks."""
    said = (m for m in evidence.mentions if m.topic == "command" and m.value.startswith("jupyter") and m.files)
    if (first := next(said, None)) or kind not in {"python", "cuda"}:
        return first
    if first_of(written(evidence, kind, ros=False, compiled=False)):
        return None
    meant = pointed_at(evidence, kind) or next(of_notebooks(evidence), None)
    return meant if meant and meant.argv[0] == "jupyter" else None
