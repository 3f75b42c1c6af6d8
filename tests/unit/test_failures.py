"""Known failures in plain words, and the shape of their table."""

from __future__ import annotations

import csv
import datetime as dt
import re
from pathlib import Path

import pytest

from roslab.engine.docker import failed_step
from roslab.knowledge import failures

TABLE = Path(failures.__file__).with_name("failures.csv")
ROWS = list(csv.DictReader(TABLE.read_text(encoding="utf-8").splitlines()))


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["pattern"][:40])
def test_every_row_has_a_pattern_that_fills_its_cause_a_source_and_a_date(row: dict[str, str]) -> None:
    groups = re.compile(row["pattern"]).groups
    assert row["cause"].format(*("x" for _ in range(groups)))
    assert row["fix"].endswith(".")
    assert row["source"].startswith("https://")
    assert dt.date.fromisoformat(row["date"])


@pytest.mark.parametrize(
    ("log", "cause"),
    [
        ("W: GPG error: EXPKEYSIG F42ED6FBAB17C654 Open Robotics", "older than June 2025"),
        ("#9 1.2 E: Unable to locate package libfoo-dev", "apt knows no package libfoo-dev"),
        ('Could not find a package configuration file provided by "GTSAM" with any', "CMake cannot find GTSAM"),
        ("my_pkg: Cannot locate rosdep definition for [catkin_simple]", "no package by the key catkin_simple"),
        ("docker.io/nvidia/cuda:10.0-devel-ubuntu18.04: not found", "has deleted the image nvidia/cuda:10.0-devel"),
        ("a.cpp:3:10: fatal error: glog/logging.h: No such file or directory", "header glog/logging.h is missing"),
        ("c++: fatal error: Killed signal terminated program cc1plus", "ran out of memory"),
    ],
)
def test_known_failures_are_found(log: str, cause: str) -> None:
    assert any(cause in found.cause for found in failures.diagnose(f"before\n{log}\nafter"))


def test_an_unknown_log_has_no_diagnosis() -> None:
    assert failures.diagnose("all went well") == ()


def test_the_failed_step_is_buildkits_own_last_word() -> None:
    log = '#8 ERROR: process "/bin/sh -c false" did not complete successfully: exit code: 1\nmore\n'
    log += "ERROR: failed to build: failed to solve: process did not complete\n"
    assert failed_step(log) == "process did not complete"
    assert failed_step("only this line\n\n") == "only this line"
