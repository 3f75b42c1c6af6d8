"""What the image runs when nothing is said."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Reason
from roslab.evidence.facts import Evidence


@dataclass(frozen=True, kw_only=True, slots=True)
class CommandChoice:
    """A command (a string runs in ``bash -c``), what else it might have been, and whether it opens windows."""

    command: tuple[str, ...] | str = ("bash",)
    candidates: tuple[tuple[str, ...], ...] = ()
    gui: bool = False
    reasons: tuple[Reason, ...] = ()


def decide_command(evidence: Evidence, config: Config, kind: Kind, dockerfile: str | None) -> CommandChoice:
    """Return the default command."""
    del evidence, kind, dockerfile
    return CommandChoice(command=config.command or ("bash",), gui=bool(config.gui))
