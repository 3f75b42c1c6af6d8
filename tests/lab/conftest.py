"""The lab for every test that needs it: skipped with the reason where there can be none."""

from __future__ import annotations

import shutil
from collections.abc import Iterator

import pytest

from . import laboratory
from .laboratory import Laboratory


@pytest.fixture(scope="session")
def lab() -> Iterator[Laboratory]:
    """Bring the lab up for all tests of this process: to ask whether it is takes seconds, and no test ends it."""
    if reason := laboratory.usable():
        pytest.skip(reason)
    with laboratory.laboratory() as running:
        yield running


@pytest.fixture(scope="module")
def x_server() -> None:
    """Skip where no program with windows can be proved."""
    if not shutil.which("Xvfb"):
        pytest.skip("Xvfb is not installed: `python3 tests/lab up` does it, as root")
