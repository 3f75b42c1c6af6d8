"""What others than pages run: a container, a session of tmux."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.candidate import LAUNCHERS, Candidate
from roslab.decide.written_commands import calls_of
from roslab.evidence.facts import Evidence, Mention
from roslab.values.dataclass import replace


def runs_of(starts: list[Mention], evidence: Evidence, kind: Kind, *, compiled: bool) -> Iterator[Candidate]:
    """Yield what such mentions start, as it is started from the root: of a repository of ROS nodes and launch files."""
    ros = kind in {"ros1", "ros2"}
    topics = {"command", "tried", *(mention.topic for mention in starts)}
    others = (mention for mention in evidence.mentions if mention.topic not in topics)
    called = (replace(mention, topic="command", source="readme") for mention in starts)
    found = calls_of(replace(evidence, mentions=(*called, *others)), kind, ros=ros, compiled=compiled)
    yield from (each for each in found if each.argv[0] in LAUNCHERS or not ros)
