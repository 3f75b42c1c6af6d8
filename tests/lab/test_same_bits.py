"""Each example that a stand-in can build is built twice from nothing, and the bits are compared."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from .laboratory import Laboratory

EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
NAMES = ["monorepo", "no_config", "own_dockerfile", "python_filter", "ros1_talker", "ros2_filter", "ros2_talker"]
"""All but the one that needs nvcc; those of ROS 2 are compared on its own packages."""


@pytest.mark.parametrize("name", NAMES)
def test_two_builds_from_nothing_have_the_same_bits(
    roslab: Callable[..., CompletedProcess[str]], lab: Laboratory, tmp_path: Path, name: str
) -> None:
    """Where they have not, the answer names each file that differs."""
    if name.startswith("ros2_") and not lab.ros2:
        pytest.skip("compared on the packages of ROS 2 alone: see `python3 tests/lab --help`")
    example = tmp_path / name
    shutil.copytree(EXAMPLES / name, example, ignore=shutil.ignore_patterns("__pycache__"))
    answer = roslab("build", example, "--twice", env=lab.environment, timeout=1800)
    assert answer.returncode == 0, answer.stderr[-3000:]
    assert "two builds, the same bits" in answer.stdout
