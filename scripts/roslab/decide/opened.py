"""Files that the default command opens as soon as it is loaded, and that nothing brings."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config
from roslab.decide.decision import Choice, Download
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence


def decide_opened(
    evidence: Evidence, config: Config, command: tuple[str, ...] | str, downloads: Iterable[Download]
) -> Choice[None]:
    """Return a warning for each; what is downloaded is there, and a command of roslab.yaml is its author's."""
    if isinstance(command, str) or config.compatible or config.custom or config.command is not None:
        return Choice(answer=None)
    started = {word for word in command if word.endswith(".py")}
    there = {each.path for each in downloads}
    told = []
    for mention in evidence.mentions:
        if mention.topic == "opened" and started & {*mention.files} and mention.value not in there:
            message = f"the default command opens {mention.value} as soon as it is loaded, which the tree does not have"
            told.append(warn(f"{message}: it stops without it; add the file, or make it by `custom`", mention))
    return Choice(answer=None, warnings=tuple(told))
