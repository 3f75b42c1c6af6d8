"""The result of a proof in a few words, from how its container ended and what it printed."""

from __future__ import annotations

from roslab.plan.proof import Proof
from roslab.values.dataclass import dataclass

MAX_NODES = 5
"""Most dead nodes that one line names; a launch of thirty nodes may lose them all."""


@dataclass(frozen=True, kw_only=True, slots=True)
class End:
    """How a proof's container ended."""

    code: int | None
    """Exit code, ``None`` if it was still running when the proof ended it."""
    seconds: float
    dead: tuple[str, ...] = ()
    """Messages about nodes of a launch that died: ``talker-2 died with exit code 1``."""


def verdict(proof: Proof, end: End, *, without: str = "") -> tuple[bool, str]:
    """Return whether a proof passed, and why in one line.

    A launch outlives its nodes: if one died, the default command does not work.
    ``without`` says why there was no display, which is reported if it may be why the proof failed.
    """
    passed, summary = judge(proof, end)
    if not passed and without:
        summary += f"; it had no display: {without}"
    if passed or proof.required:
        return passed, summary
    if proof.guessed:
        # A program that needs data or a robot is no reason to withhold a complete image
        return True, f"not proved: the guessed command {summary}; name the right one as `command` in roslab.yaml"
    return True, f"not proved: it {summary}"


def judge(proof: Proof, end: End) -> tuple[bool, str]:
    """Return whether a proof's command did what it should, whether or not anything depends on it, and why."""
    dead = end.dead
    nodes = ", ".join(dead[:MAX_NODES]) + (f" and {len(dead) - MAX_NODES} more" if len(dead) > MAX_NODES else "")
    if end.code is None and not proof.may_run_on:
        return False, f"failed: no end within {end.seconds:.0f} s"
    if end.code:
        return False, f"failed with exit code {end.code} after {end.seconds:.1f} s" + (f": {nodes}" if dead else "")
    if dead:
        launch = "ended with 0" if end.code == 0 else "still ran"
        return False, f"failed: {nodes}, though the launch itself {launch} after {end.seconds:.1f} s"
    return (
        True,
        f"passed in {end.seconds:.1f} s" if end.code == 0 else f"passed: still running after {end.seconds:.0f} s",
    )
