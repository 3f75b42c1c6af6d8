"""What is decided in one job arrives whole in the next."""

from __future__ import annotations

import dataclasses
import secrets
from pathlib import Path

import pytest

from roslab.decide.decision import Reason
from roslab.errors import ConfigurationError
from roslab.github.run import PORTABLE, Run, from_line, to_line
from roslab.pipeline import plan_repository

NAMES = (
    "ros1_talker",
    "ros2_filter",
    "ros2_talker",
    "python_filter",
    "cuda_saxpy",
    "own_dockerfile",
    "monorepo",
    "no_config",
)


def run(examples: Path, name: str = "ros2_filter") -> Run:
    plan = plan_repository(examples / name).plan
    return Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="why", cache="auto")


@pytest.mark.parametrize("name", NAMES)
def test_there_and_back(examples: Path, name: str) -> None:
    decided = run(examples, name)
    line = to_line(decided)
    assert "\n" not in line
    assert from_line(line) == decided


def test_a_large_plan_still_fits_into_an_environment_variable(examples: Path) -> None:
    decided = run(examples)
    reasons = tuple(
        Reason(question="dependencies", answer=secrets.token_hex(50), reason=secrets.token_hex(200), decisive=True)
        for _ in range(2000)
    )
    large = dataclasses.replace(decided, plan=dataclasses.replace(decided.plan, reasons=reasons))
    line = to_line(large)
    assert len(line) <= PORTABLE
    assert from_line(line).plan.base_image == decided.plan.base_image


@pytest.mark.parametrize("text", ["", "[]", "{}", "not base64", "e30=", "eJyrVipJLS5RslJQykjNyclXSMsvUkjKSSxOBQBRzAcR"])
def test_something_else_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError):
        from_line(text)
