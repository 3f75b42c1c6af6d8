"""Where the lab keeps its things, and how it knows that a kept thing is still the right one."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

HERE = Path(__file__).resolve().parent
CHECKOUT = HERE.parent.parent
MEMORY = Path("/dev/shm")
"""Where files lie in memory: https://docs.kernel.org/filesystems/tmpfs.html"""
ROOM = 4 * 1024**3
"""Bytes that must be free there; the store of a builder takes 1 GB or less, a run of act less than that."""


def home() -> Path:
    """Return the lab's home: $REPRO_LAB_HOME, else repro-action-lab in the user's cache folder."""
    chosen = os.environ.get("REPRO_LAB_HOME")
    if chosen:
        return Path(chosen).absolute()
    cache = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(cache).absolute() / "repro-action-lab"


def folder(*names: str) -> Path:
    """Return a folder under the home, made when absent."""
    path = home().joinpath(*names)
    path.mkdir(parents=True, exist_ok=True)
    return path


def memory() -> Path | None:
    """Return the folder whose files lie in memory, ``None`` where it lacks the room or may not hold programs."""
    if not MEMORY.is_dir() or os.statvfs(MEMORY).f_flag & os.ST_NOEXEC:
        return None
    return MEMORY if shutil.disk_usage(MEMORY).free >= ROOM else None


def recipe(*parts: object) -> str:
    """Return twelve hexadecimal digits that change when any part of a recipe changes.

    A part is anything `json` can write; a `Path` stands for the content of that file or folder.
    """
    digest = hashlib.sha256()
    for part in parts:
        digest.update(_bytes(part))
        digest.update(b"\0")
    return digest.hexdigest()[:12]


def _bytes(part: object) -> bytes:
    if isinstance(part, Path):
        if part.is_dir():
            files = sorted(path for path in part.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
            return b"".join(str(path.relative_to(part)).encode() + b"\0" + path.read_bytes() for path in files)
        return part.read_bytes()
    return json.dumps(part, sort_keys=True, default=str).encode()


@contextmanager
def lock(console: TextIO) -> Iterator[None]:
    """Hold the lab's lock, so that two concurrent `up` do each step once; the second waits and finds it done."""
    with (folder() / "lock").open("w") as handle:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            print("another `lab` command is at work; waiting for it", file=console, flush=True)
            fcntl.flock(handle, fcntl.LOCK_EX)
        yield
