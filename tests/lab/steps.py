"""One line of progress per step, with the time it took."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass(slots=True)
class Step:
    """What a step has to say when it is done, such as "was there" or a version."""

    note: str = ""


_line = threading.Lock()
_open: list[str] = []
"""The title whose line waits for its end; another thread's words end that line first."""


@contextmanager
def step(title: str) -> Iterator[Step]:
    """Print the title when the step begins and its seconds and note when it ends, on standard error.

    They stand on one line, unless another thread had something to say in between.
    """
    started = time.monotonic()
    _say(f"{title} ...", title, end=" ")
    told = Step()
    try:
        yield told
    except BaseException:
        _say(f"FAILED after {time.monotonic() - started:.1f} s", title)
        raise
    note = f"  {told.note}" if told.note else ""
    _say(f"{time.monotonic() - started:.1f} s{note}", title)


def _say(text: str, title: str, end: str = "\n") -> None:
    with _line:
        own = _open == [title]
        if _open and not own:
            print(file=sys.stderr)
        begins = end != "\n"
        print(text if own or begins else f"{title}: {text}", end=end, file=sys.stderr, flush=True)
        _open[:] = [title] if begins else []
