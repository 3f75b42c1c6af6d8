"""What is said of a run of a workflow that failed."""

from __future__ import annotations

from lab import why


def test_the_step_that_failed_is_told_with_what_it_said_last() -> None:
    log = "\n".join(
        [f"  said {number}" for number in range(100)]
        + [
            "  ERROR: no such image",
            "  \u274c  Failure - Main Build",
            "  \u2705  Success - Post Build",
            "x" * 5000 + "\u274c",
        ]
    )
    told = why.of_run(log).splitlines()
    assert told[0] == f"[{102 - why.BEFORE - 1} lines]"
    assert told[-2:] == ["  ERROR: no such image", "  \u274c  Failure - Main Build"]
    assert len(told) == why.BEFORE + 2


def test_the_first_failures_are_told_where_there_are_many() -> None:
    told = why.of_run("\n".join(f"::error::{number}" for number in range(1000)))
    assert told.splitlines() == [f"::error::{number}" for number in range(why.MOST)]


def test_nothing_is_told_where_no_step_failed() -> None:
    assert why.of_run("AssertionError: 1 == 2\n  \u2705  Success - Main Build") == ""
