"""Which of the lab's files begin first."""

from __future__ import annotations

import math

from lab import durations


def test_a_file_of_which_one_test_was_not_timed_has_the_tables_seconds() -> None:
    tests = [
        "tests/lab/test_slim.py::a",
        "tests/lab/test_slim.py::b",
        "tests/lab/test_clean.py::a",
        "tests/lab/new.py::a",
    ]
    measured = {"tests/lab/test_slim.py::a": 900.0, "tests/lab/test_clean.py::a": 3.5}
    found = durations.of_files(tests, measured)
    assert found["tests/lab/test_slim.py"] == durations.of_files(tests[:2], {})["tests/lab/test_slim.py"] < 900
    assert (found["tests/lab/test_clean.py"], found["tests/lab/new.py"]) == (3.5, math.inf)


def test_all_tests_of_a_file_are_added() -> None:
    tests = ["tests/lab/test_slim.py::a", "tests/lab/test_slim.py::b"]
    assert durations.of_files(tests, dict.fromkeys(tests, 2.0)) == {"tests/lab/test_slim.py": 4.0}
