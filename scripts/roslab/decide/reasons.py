"""Small helpers that every decision shares: reasons from evidence, and places in roslab.yaml."""

from __future__ import annotations

from dataclasses import replace
from typing import Protocol

from roslab.config.model import Config
from roslab.decide.decision import Reason

CONFIGURED = 1000
"""The weight of what roslab.yaml or an action's input says: it outweighs all evidence."""


class Placed(Protocol):
    """Anything that says where it stands."""

    @property
    def file(self) -> str: ...  # noqa: D102
    @property
    def line(self) -> int: ...  # noqa: D102


def because(question: str, answer: str, why: str, at: Placed | None = None, *, weight: int) -> Reason:
    """Return the reason for an answer that a fact gives."""
    return Reason(
        question=question,
        answer=answer,
        reason=why,
        file=at.file if at else None,
        line=at.line if at else None,
        weight=weight,
    )


def configured(config: Config, question: str, answer: str, path: str) -> Reason:
    """Return the reason of an answer that roslab.yaml (or an action's input) gives; it outweighs everything."""
    place = config.place(path)
    file = place.file if place else config.file
    said = f"{path} says so" if file else f"the input {path.rpartition('.')[2]} says so"
    line = place.line if place else None
    return Reason(question=question, answer=answer, reason=said, file=file, line=line, weight=CONFIGURED)


def ranked(reasons: list[Reason], answer: str) -> tuple[Reason, ...]:
    """Mark the strongest that speaks for the answer as decisive, everything else as outweighed; the strongest first."""
    ordered = sorted(reasons, key=lambda reason: -reason.weight)
    best = next((reason for reason in ordered if reason.answer == answer), None)
    return tuple(reason if reason is best else replace(reason, decisive=False) for reason in ordered)
