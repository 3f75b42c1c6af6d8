"""Headers that the image copies from templates of the tree before it compiles, as pages and scripts say."""

from __future__ import annotations

import shlex

from roslab.decide.decision import Choice, OwnScript
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_WEIGHT = 300


def with_copied_headers(choice: Choice[tuple[OwnScript, ...]], evidence: Evidence) -> Choice[tuple[OwnScript, ...]]:
    """Return the scripts with the copies before them."""
    said = [mention for mention in evidence.mentions if mention.topic == "copied_header"]
    copies = (
        OwnScript(folder="", path=m.value, command=shlex.join(("cp", m.files[0], m.value)), copies=True) for m in said
    )
    why = "the code includes it, and it is copied from {} before the build"
    reasons = (because("source", m.value, why.format(m.files[0]), m, weight=_WEIGHT) for m in said)
    return replace(choice, answer=(*copies, *choice.answer), reasons=(*reasons, *choice.reasons))
