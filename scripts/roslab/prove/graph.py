"""What a probe in the container saw of a ROS graph: nodes, topics with their messages, services."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from roslab.knowledge.graphs import belongs
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MOST = 500
"""Most nodes, topics or services that are kept; what runs in the container can claim any number."""
LONGEST = 200
"""Most characters of a name."""
_ANONYMOUS = pattern(r"_\d{1,7}_\d{13}$")
"""What ROS 1 adds to the name of an anonymous node, its process's number and the time:
http://docs.ros.org/en/noetic/api/rosgraph/html/_modules/rosgraph/names.html"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Topic:
    """A topic that a node published, or said that it would."""

    name: str
    type: str
    messages: int
    """That came from others than the player of a bag."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Graph:
    """The repository's own part of a graph, without what every graph has."""

    nodes: tuple[str, ...] = ()
    answered: tuple[str, ...] = ()
    """Nodes that answered a question without effect."""
    topics: tuple[Topic, ...] = ()
    services: tuple[str, ...] = ()
    seconds: float = 0.0
    """How long messages were counted."""
    problem: str = ""
    """Why nothing was seen, or not all."""

    def settled(self, wanted: Iterable[str]) -> bool:
        """Tell whether every topic, and every wanted one, had a message: there is nothing more to wait for."""
        talking = {topic.name for topic in self.topics if topic.messages}
        return bool(self.topics) and talking >= {*wanted, *(topic.name for topic in self.topics)}


def read(line: str, ros: str) -> Graph:
    """Read what a probe printed; whatever it is not sure to have printed is left out."""
    try:
        data = json.loads(line)
        publishers = {str(each["name"]): each for each in data.get("topics", [])[:MOST]}
        topics = (_topic(name, each, ros) for name, each in publishers.items() if not belongs(ros, "topic", name))
        return Graph(
            nodes=_own(data.get("nodes", ()), ros, "node"),
            answered=_own(data.get("answered", ()), ros, "node"),
            topics=tuple(sorted((topic for topic in topics if topic), key=lambda topic: topic.name)),
            services=_own(data.get("services", ()), ros, "service"),
            seconds=float(data.get("seconds", 0.0)),
            problem=_text(data.get("problem", "")),
        )
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return Graph(problem="the probe printed what it does not print")


def _topic(name: str, said: Mapping[str, Any], ros: str) -> Topic | None:
    """Return a topic, ``None`` if nobody but the player of a bag publishes it."""
    counts = {str(node): int(count) for node, count in said["messages"].items()}
    own = [count for node, count in counts.items() if not belongs(ros, "player", node)]
    return Topic(name=_text(name), type=_text(said["type"]), messages=sum(own)) if own or not counts else None


def _own(names: Any, ros: str, part: str) -> tuple[str, ...]:
    kept = (str(name) for name in list(names)[: 4 * MOST] if not belongs(ros, part, str(name)))
    told = {_ANONYMOUS.sub("_*", _text(name)) for name in kept if part != "node" or not belongs(ros, "player", name)}
    return tuple(sorted(told))[:MOST]


def _text(value: object) -> str:
    return "".join(letter for letter in str(value)[:LONGEST] if letter.isprintable())
