"""The lab for every test that needs it: skipped with the reason where there can be none."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from functools import cache

import pytest

from . import laboratory
from .laboratory import Laboratory

_wait = cache(laboratory.wait)


def pytest_runtest_logstart() -> None:
    """Wait once, before the first of these tests, for the `up` that tests/all has at work beside the others.

    Here it counts for no test: how long each took says which are to begin first in the next run.
    """
    _wait()


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
