"""The lab for every test that needs it: skipped with the reason where there can be none."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator

import pytest

from . import laboratory, packages
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
    """Have Xvfb on this machine, as its owner would who read what to install."""
    if shutil.which("Xvfb"):
        return
    if os.geteuid() != 0:
        pytest.skip("Xvfb is not installed, and only root can install it")
    packages.install(["xvfb"])
