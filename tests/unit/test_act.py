"""A run that act's own race ended is started again; what the workflow itself did is not."""

from __future__ import annotations

from pathlib import Path

import pytest

from lab.act import MOST_RUNS, RACE, Result, unless_raced


def ended(log: str) -> Result:
    return Result(exit_code=2, log=log, jobs={}, outputs={}, summary="")


@pytest.mark.parametrize(
    ("logs", "place", "runs"),
    [
        ([RACE, "built"], None, 2),
        ([RACE] * 9, None, MOST_RUNS),
        (["failed", "built"], None, 1),
        ([RACE, "built"], Path("kept"), 1),
    ],
    ids=["raced", "always", "failed", "kept"],
)
def test_how_often_a_run_is_started(logs: list[str], place: Path | None, runs: int) -> None:
    left = iter(logs)

    def run(*, place: Path | None) -> Result:
        return ended(next(left))

    assert unless_raced(run)(place=place).log == logs[runs - 1]
    assert len(list(left)) == len(logs) - runs
