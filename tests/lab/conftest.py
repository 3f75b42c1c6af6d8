"""The lab for every test that needs it: skipped with the reason where there can be none."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from . import laboratory
from .laboratory import Laboratory


@pytest.fixture(scope="module")
def lab() -> Iterator[Laboratory]:
    """Bring the lab up for a module of tests."""
    if reason := laboratory.usable():
        pytest.skip(reason)
    with laboratory.laboratory() as running:
        yield running
