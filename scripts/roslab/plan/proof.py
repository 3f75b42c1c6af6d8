"""One command that is run inside an image before it gets a tag."""

from __future__ import annotations

import shlex
from typing import Literal

from roslab.values.dataclass import dataclass

ProofRung = Literal[0, 1, 4]
"""Rungs of the ladder with commands of their own; 2, 3 and 5 are seen while the default command runs."""
LONGEST = 200
"""Most characters of a command that are shown."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Proof:
    """One command that is run in a container of the image."""

    name: str
    command: tuple[str, ...]
    """An argv."""
    required: bool = True
    """If it fails, the image gets no tag; otherwise it is only tried and told."""
    limit: int | None = None
    """Seconds after which it has failed, ``None`` for the usual."""
    guessed: bool = False
    """Nobody named the command, and it may be a wrong one."""
    may_run_on: bool = False
    """It may run without an end: still running after the proof's seconds counts as passed, like exit code 0."""
    display: bool = False
    """It opens windows: it runs with a virtual display, of which a picture is kept."""
    rung: ProofRung | None = None
    """The rung of the ladder that it belongs to; ``None``: an image without a program, of which a shell is started."""
    entrypoint: bool = True
    """It is started through the image's entry point; that of an author's Dockerfile may be the program itself."""
    graph: Literal["ros1", "ros2"] | None = None
    """Whose nodes and topics are looked at while it runs."""


def describe(proof: Proof) -> str:
    """Return the command as a person would type it; of a script only the first line, of a long one only the start."""
    words = [
        f"{first} …" if (first := word.partition("\n")[0]) != (whole := word.rstrip("\n")) else whole
        for word in proof.command
    ]
    text = shlex.join(words) or "(the image's own command)"
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"
