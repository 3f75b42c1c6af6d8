"""Headers and settings that the image copies from other files of the tree, as pages and scripts say."""

from __future__ import annotations

import shlex

from roslab.decide.decision import Choice, OwnScript
from roslab.decide.reasons import because, page_of
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace

_WEIGHT = 300


def with_copied_files(choice: Choice[tuple[OwnScript, ...]], evidence: Evidence) -> Choice[tuple[OwnScript, ...]]:
    """Return the scripts with the copies before them."""
    said = [mention for mention in evidence.mentions if mention.topic == "copied"]
    copies = (
        OwnScript(folder="", path=m.value, command=shlex.join(("cp", m.files[0], m.value)), copies=True) for m in said
    )
    reasons = (because("source", m.value, _why(m), m, weight=_WEIGHT) for m in said)
    return replace(choice, answer=(*copies, *choice.answer), reasons=(*reasons, *choice.reasons))


def _why(said: Mention) -> str:
    if said.value.rpartition(".")[2].startswith(("h", "cuh")):
        return f"the code includes it, and it is copied from {said.files[0]} before the build"
    return f"{page_of(said.file)} copies it from {said.files[0]}"
