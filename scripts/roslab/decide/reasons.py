"""How every decision gives its reasons: from a fact, from roslab.yaml, and by weight."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Protocol

from roslab.config.model import Config
from roslab.decide.decision import Reason, Warning_

CONFIGURED = 1000
"""The weight of what roslab.yaml or an action's input says: it outweighs all evidence."""


class Placed(Protocol):
    """Anything that says where it stands: a fact of the evidence, or an origin (``values.origin``)."""

    @property
    def file(self) -> str | None: ...  # noqa: D102
    @property
    def line(self) -> int | None: ...  # noqa: D102


def because(
    question: str, answer: str, why: str, at: Placed | None = None, *, weight: int, decisive: bool = True
) -> Reason:
    """Return the reason for an answer that a fact gives; not ``decisive``: it was known, and not enough."""
    return Reason(
        question=question,
        answer=answer,
        reason=why,
        file=at.file if at else None,
        line=at.line if at else None,
        weight=weight,
        decisive=decisive,
    )


def warn(message: str, at: Placed | None = None) -> Warning_:
    """Return a warning, with its place where it has one."""
    return Warning_(message=message, file=at.file if at else None, line=at.line if at else None)


def configured(config: Config, question: str, answer: str, path: str) -> Reason:
    """Return the reason of an answer that roslab.yaml (or an action's input) gives; it outweighs everything."""
    place = config.place(path)
    file = place.file if place else config.file
    said = f"{path} says so" if file else f"the input {path.rpartition('.')[2]} says so"
    line = place.line if place else None
    return Reason(question=question, answer=answer, reason=said, file=file, line=line, weight=CONFIGURED)


def strongest(reasons: Iterable[Reason]) -> Reason:
    """Return the reason that weighs most, the first of equals."""
    return max(reasons, key=lambda reason: reason.weight)


def ranked(reasons: Iterable[Reason], answer: str) -> tuple[Reason, ...]:
    """Return the reasons by weight; only the strongest that speaks for the answer is decisive."""
    ordered = sorted(reasons, key=lambda reason: -reason.weight)
    best = next((reason for reason in ordered if reason.answer == answer), None)
    return tuple(reason if reason is best else replace(reason, decisive=False) for reason in ordered)


def outweighed(reasons: Iterable[Reason], by: Reason) -> tuple[Reason, ...]:
    """Return the reasons in their order; those that answer the question of ``by`` otherwise are not decisive."""
    return tuple(
        replace(reason, decisive=False) if reason.question == by.question and reason.answer != by.answer else reason
        for reason in reasons
    )
