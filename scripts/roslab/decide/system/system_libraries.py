"""Libraries of the tree that the image copies into the system before it compiles, as a page or a script does."""

from __future__ import annotations

import shlex

from roslab.decide.decision import Choice, OwnScript
from roslab.decide.reasons import because, page_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_WEIGHT = 300


def with_system_libraries(choice: Choice[tuple[OwnScript, ...]], evidence: Evidence) -> Choice[tuple[OwnScript, ...]]:
    """Return the scripts with the copies before them."""
    said = [mention for mention in evidence.mentions if mention.topic == "system_library"]
    copies = (
        OwnScript(
            folder="",
            path=m.files[0],
            command=shlex.join(("install", "-D", "--mode=755", f"--target-directory={m.value}", *m.files))
            + " && ldconfig",
            copies=True,
        )
        for m in said
    )
    why = "it is linked, and {} copies it to {}"
    reasons = (because("source", m.files[0], why.format(page_of(m.file), m.value), m, weight=_WEIGHT) for m in said)
    return replace(choice, answer=(*copies, *choice.answer), reasons=(*reasons, *choice.reasons))
