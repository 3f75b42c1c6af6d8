"""Building and sorting the reasons of a decision."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Protocol

from roslab.config.model import Config
from roslab.decide.decision import Reason, Warning_
from roslab.values.dataclass import replace
from roslab.values.origin import Input, Option, Place
from roslab.values.pattern import pattern

CONFIGURED = 1000
"""The weight of what roslab.yaml, an input or an option says."""

_README = pattern(r"readme(?:\.\w+)?", re.IGNORECASE)
"""The page at the root that is called so, in no other language: not ``README_CN.md``."""


class Placed(Protocol):
    """Anything with a place: a fact of the evidence, or an origin; an input or an option has no file."""

    @property
    def file(self) -> str | None: ...  # noqa: D102
    @property
    def line(self) -> int | None: ...  # noqa: D102


def because(
    question: str, answer: str, why: str, at: Placed | None = None, *, weight: int, decisive: bool = True
) -> Reason:
    """Return the reason that a fact gives for an answer; pass ``decisive=False`` if it did not decide."""
    return Reason(
        question=question,
        answer=answer,
        reason=why,
        file=at.file if at else None,
        line=at.line if at else None,
        weight=weight,
        decisive=decisive,
    )


def of_readme(file: str) -> bool:
    """Tell whether a file is the README at the root, in any language, and no other page beside it."""
    return "/" not in file and file.lower().startswith("readme")


def page_of(file: str) -> str:
    """Return what a reason calls a page of the repository: the README at the root, any other by its path."""
    return "the README" if _README.fullmatch(file) else file


def warn(message: str, at: Placed | None = None) -> Warning_:
    """Return a warning with its place; one about an input or an option begins with its name instead."""
    message = f"{at}: {message}" if isinstance(at, Input | Option) else message
    return Warning_(message=message, file=at.file if at else None, line=at.line if at else None)


def configured(config: Config, question: str, answer: str, path: str) -> Reason:
    """Return the reason for an answer set by roslab.yaml, an input or an option; it outweighs all evidence.

    ``path`` is that of the key, with dots. An input or an option has no place, so the reason names it.
    """
    origin = config.origin(path) or (Place(file=config.file) if config.file else None)
    named = origin if isinstance(origin, Input | Option) else path
    return because(question, answer, f"{named} says so", origin, weight=CONFIGURED)


def strongest(reasons: Iterable[Reason]) -> Reason:
    """Return the reason with the highest weight, the first of equals."""
    return max(reasons, key=lambda reason: reason.weight)


def ranked(reasons: Iterable[Reason], answer: str) -> tuple[Reason, ...]:
    """Return the reasons sorted by weight; only the strongest one for the answer is decisive."""
    ordered = sorted(reasons, key=lambda reason: -reason.weight)
    best = next((reason for reason in ordered if reason.answer == answer), None)
    return tuple(reason if reason is best else replace(reason, decisive=False) for reason in ordered)


def outweighed(reasons: Iterable[Reason], by: Reason) -> tuple[Reason, ...]:
    """Return the reasons in their order; those with another answer to the question of ``by`` are not decisive."""
    return tuple(
        replace(reason, decisive=False) if reason.question == by.question and reason.answer != by.answer else reason
        for reason in reasons
    )
