"""The record that an image carries, and the first difference of a later climb from it."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from roslab.config.model import ProofGoals, ProofLimits
from roslab.errors import ConfigurationError
from roslab.plan.ladder import Ladder, Rung
from roslab.plan.proof import Proof
from roslab.plan.record import VERSION, Record, difference, from_json, to_json, to_result

INSTALLS = Rung(number=0, state="held", said="found", facts=("found",))
TALKS = Rung(
    number=2, state="held", said="7 messages", facts=("node /talker", "topic /chatter [std_msgs/String] talks")
)
LADDER = Ladder(rungs=(INSTALLS, TALKS))
RECORD = Record(
    version=VERSION,
    proofs=(Proof(name="the default command starts", command=('echo "a\nb"', "ü"), rung=1, graph="ros1"),),
    limits=ProofLimits(memory="8g"),
    goals=ProofGoals(rung=2, topics=("/chatter",)),
    gpu=False,
    platforms=(("linux/amd64", LADDER),),
)


def test_what_was_written_is_read() -> None:
    line = to_json(RECORD)
    assert "\n" not in line
    assert from_json(line) == RECORD
    assert RECORD.of("linux/amd64") == LADDER
    assert RECORD.of("linux/arm64") is None


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"version": 1}', to_json(RECORD).replace('"gpu"', '"x"'), "[" * 99999]
)
def test_anything_else_is_none(text: str) -> None:
    with pytest.raises(ConfigurationError, match="not the record of a proof"):
        from_json(text)


def test_a_record_of_another_time() -> None:
    with pytest.raises(ConfigurationError, match="version 2, and this program reads version 1"):
        from_json(to_json(replace(RECORD, version=2)))


def with_talks(**changes: object) -> Ladder:
    return Ladder(rungs=(INSTALLS, replace(TALKS, **changes)))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("seen", "said"),
    [
        (LADDER, ""),
        (with_talks(said="9 messages"), ""),
        (
            with_talks(facts=("node /talker", "node /b")),
            f"rung 2, talks: `{TALKS.facts[1]}` was recorded, and is not so now; now there is `node /b`",
        ),
        (with_talks(facts=(*TALKS.facts, "node /b")), "rung 2, talks: `node /b` is so now, and was not recorded"),
        (
            with_talks(state="missed", said="0 messages", facts=()),
            "rung 2, talks: it held when it was recorded (7 messages), and now did not hold (0 messages)",
        ),
        (Ladder(rungs=(TALKS,)), "rung 0, installs: recorded (found), and now there is nothing of it"),
        (
            Ladder(rungs=(INSTALLS, TALKS, Rung(number=3, state="held", said="a window"))),
            "rung 3, shows: not recorded, and now seen (a window)",
        ),
    ],
)
def test_the_first_difference(seen: Ladder, said: str) -> None:
    assert difference(LADDER, seen) == said


def test_the_signed_result_names_each_rung_and_calls_none_that_is_missed_passed() -> None:
    missed = replace(TALKS, state="missed", needed="a message")
    both = replace(RECORD, platforms=(*RECORD.platforms, ("linux/arm64", Ladder(rungs=(INSTALLS, missed)))))
    made = json.loads(to_result(both, url="https://example.org/run"))
    assert made["result"] == "WARNED"
    assert made["passedTests"] == [
        "linux/amd64: rung 0, installs",
        "linux/amd64: rung 2, talks",
        "linux/arm64: rung 0, installs",
    ]
    assert made["warnedTests"] == ["linux/arm64: rung 2, talks"]
    assert made["failedTests"] == []
    assert from_json(json.dumps(made["configuration"][0]["annotations"])) == both
    assert json.loads(to_result(RECORD, url=""))["result"] == "PASSED"


@pytest.mark.parametrize("number", [3, 5])
def test_a_reader_without_a_display_or_a_gpu_sees_no_difference(number: int) -> None:
    here = Ladder(rungs=(INSTALLS, Rung(number=number, state="unseen", said="x")))
    there = Ladder(rungs=(INSTALLS, Rung(number=number, state="held", said="x", facts=("window",))))
    assert (difference(there, here), difference(here, there)) == ("", "")
    missed = Ladder(rungs=(INSTALLS, Rung(number=number, state="missed", said="x")))
    assert difference(there, missed)
