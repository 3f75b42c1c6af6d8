"""Steps of an author's Dockerfile at which the build stops."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.prose.ungiven import ungiven
from roslab.knowledge.stopped_steps import stopped
from roslab.repository.checkout import Repository

_GOES_ON = "||"
"""A step that has another way, or none and goes on."""


def stops(repository: Repository, written: Sequence[Instruction], base: str | None) -> str | None:
    """Return why the build of an image stops at one of its steps, ``None`` where it may not."""
    releases = base or ""
    for each in written:
        if each.name != "RUN" or _GOES_ON in each.text:
            continue
        releases = f"{releases}\n{each.text}"
        if why := stopped(each.text, releases):
            return f"line {each.line} {why}"
    return ungiven(repository, written)
