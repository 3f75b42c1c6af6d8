"""The reason for a default command, with the number of the others that were found."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from roslab.decide.candidate import Candidate, program_of


def among(first: Candidate, ours: Sequence[Candidate], found: Iterable[Candidate]) -> str:
    """Return the reason for a command, with how many other programs there are, and whether pages run those later.

    ``ours``: those that might have been taken; ``found``: all that are offered.
    """
    own = program_of(first.argv)
    run = list(dict.fromkeys(program_of(c.argv) for c in ours if c.strong))
    if others := len({*run} - {own}):
        order = "before" if run[:1] == [own] or own not in run else "and"
        return f"{first.why}, {order} {others} other{'s' * (others > 1)}"
    if more := len({program_of(c.argv) for c in found} - {own}):
        return f"{first.why}; {more} {'others were' if more > 1 else 'other was'} found beside it"
    return f"the only one: {first.why}"
