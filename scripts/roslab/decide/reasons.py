"""Small helpers that every decision shares: reasons from evidence, and places in roslab.yaml."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Reason


def configured(config: Config, question: str, answer: str, path: str) -> Reason:
    """Return the reason of an answer that roslab.yaml (or an action's input) gives; it outweighs everything."""
    place = config.place(path)
    file = place.file if place else config.file
    said = f"{path} says so" if file else f"the input {path.rpartition('.')[2]} says so"
    return Reason(question=question, answer=answer, reason=said, file=file, line=place.line if place else None, weight=1000)


def ranked(reasons: list[Reason], answer: str) -> tuple[Reason, ...]:
    """Mark what spoke for the answer as decisive and everything else as outweighed, the strongest first."""
    ordered = sorted(reasons, key=lambda reason: -reason.weight)
    best = next((reason for reason in ordered if reason.answer == answer), None)
    return tuple(
        reason if reason is best else Reason(
            question=reason.question,
            answer=reason.answer,
            reason=reason.reason,
            file=reason.file,
            line=reason.line,
            weight=reason.weight,
            decisive=False,
        )
        for reason in ordered
    )
