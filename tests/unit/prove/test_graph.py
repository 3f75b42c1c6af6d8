"""What a probe prints, as far as it can be believed: a program in the container may print the like."""

from __future__ import annotations

import json
from typing import Any

import pytest

from roslab.prove.graph import Graph, Topic, read

SEEN: dict[str, Any] = {
    "nodes": ["/rosout", "/talker", "/listener_123_1600000000000", "/play_1600000000000000000"],
    "answered": ["/rosout", "/talker"],
    "services": ["/talker/get_loggers", "/add_two_ints", "/play_1600000000000000000/pause_playback"],
    "topics": [
        {"name": "/rosout", "type": "rosgraph_msgs/Log", "messages": {"/talker": 3}},
        {"name": "/chatter", "type": "std_msgs/String", "messages": {"/talker": 3, "/other": 4}},
        {"name": "/scan", "type": "sensor_msgs/LaserScan", "messages": {"/play_1600000000000000000": 90}},
        {"name": "/tf", "type": "tf2_msgs/TFMessage", "messages": {"/play_1600000000000000000": 9, "/talker": 2}},
    ],
    "seconds": 9.8,
}


def test_what_every_graph_has_is_not_the_repositorys() -> None:
    found = read(json.dumps(SEEN), "ros1")
    assert found.nodes == ("/listener_*", "/talker")
    assert found.answered == ("/talker",)
    assert found.services == ("/add_two_ints",)
    assert found.topics == (
        Topic(name="/chatter", type="std_msgs/String", messages=7),
        Topic(name="/tf", type="tf2_msgs/TFMessage", messages=2),
    )


def test_there_is_nothing_more_to_wait_for() -> None:
    found = read(json.dumps(SEEN), "ros1")
    assert found.settled(())
    assert not found.settled(["/scan"])
    assert not Graph().settled(())


@pytest.mark.parametrize(
    "line",
    [
        "",
        "hello",
        "[]",
        '{"topics": [3]}',
        '{"topics": [{"name": "/a", "messages": "x"}]}',
        '{"seconds": "x"}',
        "[" * 99999,
    ],
)
def test_anything_else_is_no_graph(line: str) -> None:
    found = read(line, "ros1")
    assert not found.nodes
    assert found.problem


def test_a_name_cannot_break_out_of_its_line() -> None:
    found = read(json.dumps({"nodes": ["/a\n::error::x\x1b[31m"], "topics": []}), "ros1")
    assert found.nodes == ("/a::error::x[31m",)
