"""A guard against code that does not come to an end, for tests with inputs that are made to be hard."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

LIMIT = 60
"""Seconds of this process's own time: what backtracks or doubles itself takes minutes to days, the rest below one."""


@contextmanager
def ends() -> Iterator[None]:
    """Fail where the body takes more than :data:`LIMIT`.

    This is no measure of speed: machines differ, and a busy one makes any narrow limit fail. Speed is measured in
    ``benchmarks/``, as ratios.
    """
    begun = time.process_time()
    yield
    spent = time.process_time() - begun
    assert spent < LIMIT, f"{spent:.0f} s of work: its time does not grow with the length of the input alone"
