"""How many tests ran, by what their runners print."""

from __future__ import annotations

import pytest

from roslab.knowledge.test_counts import count_of_tests


@pytest.mark.parametrize(
    ("output", "ran"),
    [
        ("all is well\n", None),
        ("\n----\nRan 0 tests in 0.000s\n\nOK\n", 0),
        ("Ran 1 test in 0.1s\n\nOK\n", 1),
        ("Ran 3 tests in 0.1s\n\nOK (skipped=3)\n", 0),
        ("Ran 3 tests in 0.1s\n\nFAILED (failures=1, skipped=1)\n", 2),
        ("=== no tests ran in 0.01s ===\n", 0),
        ("==== 2 skipped, 1 warning in 0.01s ====\n", 0),
        ("==== 4 passed, 2 skipped in 0.01s ====\n", 4),
        ("==== 1 failed, 4 passed in 0.01s ====\n", 4),
        ("Test project /b\nNo tests were found!!!\n", 0),
        ("100% tests passed, 0 tests failed out of 12\n", 12),
        (
            "[==========] Running 0 tests from 0 test suites.\n[==========] 0 tests from 0 test suites ran. (0 ms)",
            0,
        ),
        ("[==========] 2 tests from 1 test case ran. (0 ms total)\n", 2),
        ("SUMMARY\n * RESULT: SUCCESS\n * TESTS: 0\n * ERRORS: 0\n", 0),
        ("Summary: 5 tests, 0 errors, 0 failures, 0 skipped\n", 5),
    ],
)
def test_the_count(output: str, ran: int | None) -> None:
    assert count_of_tests(output) == ran
