"""Variables that the pages of the author set, without which the build or a launch file stops."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence, Mention
from roslab.knowledge.search_paths import search_paths

SET = 40
"""Weight of the reason; nothing competes with it."""


def decide_variables(evidence: Evidence, config: Config) -> Choice[tuple[tuple[str, str], ...]]:
    """Return each variable with the value that roslab.yaml gives it, else a page first."""
    if config.compatible:
        return Choice(answer=())
    given = dict(config.env)
    found: dict[str, tuple[str, Mention]] = {}
    for mention in evidence.mentions:
        name, _, value = mention.value.partition("=")
        if mention.topic == "variable":
            found.setdefault(name, (given.get(name, value), mention))
    return Choice(
        answer=tuple((name, value) for name, (value, _) in found.items()),
        reasons=tuple(
            because("workspace", f"{name}={value}", f"a page sets it, and {_reader(name)} reads it", place, weight=SET)
            for name, (value, place) in found.items()
        ),
    )


def _reader(name: str) -> str:
    return "the simulator" if name in search_paths() else "the tree"
