"""Programs of packages by the names that they are installed by, where pages leave the ending out."""

from __future__ import annotations

from roslab.decide.candidate import Candidate
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.program_endings import ENDING
from roslab.values.dataclass import replace


def with_ending(candidate: Candidate, evidence: Evidence) -> Candidate:
    """Return ``ros2 run demo talker`` as ``ros2 run demo talker.py`` where its package has it by that name alone."""
    at = {"rosrun": 1, "ros2": 2}.get(candidate.argv[0], 0)
    words = candidate.argv[at : at + 2]
    if not at or not any(m.topic == "ending" and m.value == " ".join(words) for m in evidence.mentions):
        return candidate
    argv = (*candidate.argv[: at + 1], f"{words[1]}{ENDING}", *candidate.argv[at + 2 :])
    return replace(candidate, argv=argv, why=f"{candidate.why} without its ending")
