"""Programs of packages by the names that they are installed by, where pages leave the ending out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.candidate import Candidate
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.program_endings import ENDING
from roslab.values.dataclass import replace

_BEFORE = {"rosrun": 1, "ros2": 2}
"""How many words stand before the package."""


def with_endings(candidates: Iterable[Candidate], evidence: Evidence) -> Iterator[Candidate]:
    """Yield ``ros2 run demo talker`` as ``ros2 run demo talker.py`` where its package has it by that name alone."""
    short = {each.value for each in evidence.mentions if each.topic == "ending"}
    for candidate in candidates:
        at = _BEFORE.get(candidate.argv[0], 0)
        words = candidate.argv[at : at + 2]
        if at and " ".join(words) in short:
            argv = (*candidate.argv[: at + 1], f"{words[1]}{ENDING}", *candidate.argv[at + 2 :])
            yield replace(candidate, argv=argv, why=f"{candidate.why} without its ending")
        else:
            yield candidate
