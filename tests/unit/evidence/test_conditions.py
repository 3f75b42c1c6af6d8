"""Conditions of REP 149."""

from __future__ import annotations

import pytest

from roslab.evidence.ros.conditions import holds

VARIABLES = {"ROS_VERSION": "2", "ROS_DISTRO": "humble"}


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        (None, True),
        ("$ROS_VERSION == 2", True),
        ("$ROS_VERSION == 1", False),
        ("$ROS_VERSION != 1 and $ROS_DISTRO == 'humble'", True),
        ("$ROS_VERSION == 1 or $ROS_DISTRO >= foxy", True),
        ("($ROS_VERSION == 1 or $ROS_VERSION == 2) and $ROS_DISTRO == jazzy", False),
        ("$UNKNOWN == ''", True),
        ("$UNKNOWN == 1", False),
    ],
)
def test_a_condition_is_evaluated(condition: str | None, expected: bool) -> None:
    assert holds(condition, VARIABLES) is expected


@pytest.mark.parametrize("condition", ["$ROS_VERSION", "and or", "(" * 50, "(" * 5000, "$A === 1", "$A == 1 $B", "…"])
def test_what_cannot_be_read_counts_as_true(condition: str) -> None:
    assert holds(condition, VARIABLES)
