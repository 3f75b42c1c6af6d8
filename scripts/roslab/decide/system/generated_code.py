"""Programs of the tree that the image runs before it compiles, since CMake needs the code that they write."""

from __future__ import annotations

from roslab.decide.decision import Choice, OwnScript
from roslab.decide.reasons import because, page_of
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace

_WEIGHT = 300


def with_generated_code(choice: Choice[tuple[OwnScript, ...]], evidence: Evidence) -> Choice[tuple[OwnScript, ...]]:
    """Return the scripts with these before them: what fails is told, and CMake then says what it lacks."""
    said = [mention for mention in evidence.mentions if mention.topic == "generates"]
    scripts = (OwnScript(folder=m.inside, path=m.files[0], command=m.value, copies=True) for m in said)
    reasons = (because("source", m.files[0], _why(m), m, weight=_WEIGHT) for m in said)
    return replace(choice, answer=(*scripts, *choice.answer), reasons=(*reasons, *choice.reasons))


def _why(said: Mention) -> str:
    if said.source == "readme":
        return f"{page_of(said.file)} runs it, and it writes code that CMake compiles"
    return "CMake stops without the code that it writes"
