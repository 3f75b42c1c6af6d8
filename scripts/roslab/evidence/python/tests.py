"""Files of tests in Python, and which runner knows how to start them."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.facts import Runner, TestFile
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_NAMED = pattern(r"^test_.*\.py$|_test\.py$|\.test\.py$")
"""https://docs.pytest.org/en/stable/explanation/goodpractices.html#conventions-for-python-test-discovery, and those of
https://github.com/ros2/launch/tree/rolling/launch_testing"""
_STYLE = pattern(r"^\s*(?:from|import)\s+ament_\w+", re.MULTILINE)
"""Checkers of style that `ros2 pkg create` writes into every package: they say nothing of what the code does.
https://github.com/ament/ament_lint"""
MAX_FILES = 200
"""Most files that are read."""


def read(repository: Repository) -> tuple[TestFile, ...]:
    """Return the files whose tests start by themselves, sorted by path; those that a rostest starts are left out."""
    files = [file for file in repository.suffixed(".py") if _NAMED.search(file.name) and not places.vendored(file.path)]
    nearest = sorted(files, key=lambda file: (file.path.count("/"), file.path))[:MAX_FILES]
    found = ((file.path, _runner(repository.read(file))) for file in nearest)
    return tuple(TestFile(file=path, line=1, runner=runner) for path, runner in sorted(found) if runner)


def _runner(text: str) -> Runner | None:
    if "rostest" in text or _STYLE.search(text):
        return None
    if "generate_test_description" in text:
        return "launch_test"
    if "TestCase" in text:
        return "unittest"
    return "pytest" if "def test" in text else None
