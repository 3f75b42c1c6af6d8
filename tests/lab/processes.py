"""Processes the lab starts: each is remembered by id and start time, and only a remembered one is ever ended."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from .command import LabError
from .home import folder


def _record(name: str) -> Path:
    return folder("run") / f"{name}.json"


def _born(pid: int) -> str:
    """Return a process's start time in clock ticks, "" when it is gone or a zombie: an id may be used again."""
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return ""
    return "" if fields[0] == "Z" else fields[19]


def running(name: str) -> int | None:
    """Return the id of the process the lab started under this name, None when it is not running any more."""
    try:
        record = json.loads(_record(name).read_text())
    except (OSError, ValueError):
        return None
    pid = int(record["pid"])
    return pid if _born(pid) == record["born"] else None


def start(name: str, argv: Sequence[str | Path], *, ready: Callable[[], bool], seconds: float = 30) -> None:
    """Start a process of its own session, remember it, and wait until `ready()` says so.

    Raises LabError with the end of its log when it dies or does not get ready in time.
    """
    words = [str(word) for word in argv]
    log = folder("log") / f"{name}.log"
    with log.open("w") as handle:
        process = subprocess.Popen(
            words, stdin=subprocess.DEVNULL, stdout=handle, stderr=handle, start_new_session=True, cwd="/"
        )
    _record(name).write_text(json.dumps({"pid": process.pid, "born": _born(process.pid), "argv": words}))
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if process.poll() is not None:
            break
        if ready():
            return
        time.sleep(0.1)
    code = process.poll()
    state = f"not ready after {seconds:.0f} s" if code is None else f"ended with code {code}"
    stop(name)
    tail = "\n".join("    " + line for line in log.read_text(errors="replace").splitlines()[-15:])
    raise LabError(f"{name}: {state} (all of it: {log})\n{tail}")


def stop(name: str, *, seconds: float = 30) -> bool:
    """End the process the lab started under this name and tell whether there was one; others' are left alone."""
    pid = running(name)
    _record(name).unlink(missing_ok=True)
    if pid is None:
        return False
    born = _born(pid)
    for word in (signal.SIGTERM, signal.SIGKILL):
        if _born(pid) == born:
            os.kill(pid, word)
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            _reap(pid)
            if _born(pid) != born:
                return True
            time.sleep(0.05)
    raise LabError(f"{name}: process {pid} does not end")


def end_orphans(place: Path) -> None:
    """End what a killed process of the lab left running: only its helpers name a socket or file below `place`.

    An engine that was killed leaves its containerd and the shims of its containers.
    """
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            words = (entry / "cmdline").read_text().split("\0")
        except OSError:
            continue
        if any(word.startswith(f"{place}/") for word in words) and int(entry.name) != os.getpid():
            os.kill(int(entry.name), signal.SIGKILL)


def _reap(pid: int) -> None:
    """Collect a child of ours, so that it does not stay as a zombie; another's child is not ours to collect."""
    try:
        os.waitpid(pid, os.WNOHANG)
    except ChildProcessError:
        return
