"""One line of progress per step, with the time it took."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass(slots=True)
class Step:
    """What a step has to say when it is done, such as "was there" or a version."""

    note: str = ""


@contextmanager
def step(title: str) -> Iterator[Step]:
    """Print the title when the step begins and its seconds and note when it ends, on one line of standard error."""
    started = time.monotonic()
    print(f"{title} ...", end=" ", file=sys.stderr, flush=True)
    told = Step()
    try:
        yield told
    except BaseException:
        print(f"FAILED after {time.monotonic() - started:.1f} s", file=sys.stderr, flush=True)
        raise
    note = f"  {told.note}" if told.note else ""
    print(f"{time.monotonic() - started:.1f} s{note}", file=sys.stderr, flush=True)
