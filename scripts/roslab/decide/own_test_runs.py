"""Commands that only run tests or benchmarks."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.decide.candidate import LAUNCHERS
from roslab.evidence import places


def runs_tests(argv: Sequence[str]) -> bool:
    """Tell whether a command only runs tests or benchmarks; a node that a page starts by its name may be called so."""
    programs = [part for part in argv if argv[0] not in LAUNCHERS and part.endswith(".py")]
    return any(part.endswith("_test.py") or places.test(part) for part in programs)
