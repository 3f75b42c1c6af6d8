"""What a proof's program prints, kept in a file of limited size: a program may print without end."""

from __future__ import annotations

import subprocess
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from io import BufferedReader
from pathlib import Path
from typing import cast

CHUNK = 1 << 16


@contextmanager
def kept(process: subprocess.Popen[bytes], log: Path, *, head: int, tail: int) -> Iterator[None]:
    """Write the first ``head`` and the last ``tail`` bytes of a process's output to a file while the context lasts.

    The context ends when the output does. The process must have been started with ``stdout=PIPE``.
    """
    thread = threading.Thread(target=_copy, args=(process, log, head, tail), daemon=True)
    thread.start()
    try:
        yield
    finally:
        thread.join(60)  # a grandchild may hold the pipe


def _copy(process: subprocess.Popen[bytes], log: Path, head: int, tail: int) -> None:
    pipe = cast("BufferedReader", process.stdout)
    left, end = head, bytearray()
    with log.open("wb") as file:
        while data := pipe.read1(CHUNK):
            file.write(data[:left])
            file.flush()
            end += data[left:]
            left = max(0, left - len(data))
            if len(end) > 2 * tail:
                del end[:-tail]
        file.write(end[-tail:])
