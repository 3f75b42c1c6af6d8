"""The author's own Dockerfile that does not build: the next build generates one, by ``dockerfile: false``."""

from __future__ import annotations

from roslab.explain.answer import Answer
from roslab.repair.change import Asked, Change, Given
from roslab.repair.said import by_machine, said

KEY = "dockerfile"


def in_place_of(answer: Answer, given: Given) -> tuple[Change, ...]:
    """Return the change with which a Dockerfile is generated in place of one that was found in the tree.

    None where roslab.yaml names that one, or is of an old format, and where the network or the machine failed: what is
    generated would fail there, too. None, either, where the log is not that of a build that failed.
    """
    author = given.plan.author_dockerfile
    named = given.config.dockerfile or given.config.generation != "today"
    if author is None or named or any(map(by_machine, answer.explanations)):
        return ()
    found = next((each for each in answer.explanations if each.step or each.error), None)
    if found is None or not answer.of_build:
        return ()
    what, place = said(found, given)
    change = Change(
        key=KEY,
        value="false",
        failure=found.id or "",
        certain=True,
        asked=Asked(what=what, place=place),
        why=f"{author.dockerfile} does not build: {what}{f' at {place}' if place else ''}",
    )
    return (change,)
