"""The engine's disk: how much is free, and making room on it."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from roslab.engine.docker import last_line, output, say

REMOVAL_SECONDS = 600.0


def free() -> int | None:
    """Return the free bytes where the engine keeps its images, ``None`` if that is on another machine."""
    answer = output(["docker", "info", "--format", "{{.DockerRootDir}}"])
    folder = answer.stdout.strip()
    try:
        return shutil.disk_usage(folder).free if answer.returncode == 0 and folder else None
    except OSError:
        return None


def prune(*, most: str | None = None) -> None:
    """Empty the store of the current builder; what it built was pushed, and so was its cache.

    With ``most``, such as ``20gb``, that much is kept: what was used last.
    """
    words = ["--max-used-space", most] if most else ["--all"]
    answer = output(["docker", "buildx", "prune", "--force", *words], timeout=REMOVAL_SECONDS)
    if answer.returncode:
        say(f"the builder's store was not emptied: {last_line(answer.stderr)}")


def remove(folder: str) -> bool:
    """Remove a folder of the machine and tell whether it is gone; a link is left alone."""
    path = Path(folder)
    if path.is_symlink() or not path.is_dir():
        return False
    root = [] if os.access(path.parent, os.W_OK) else ["sudo", "--non-interactive"]
    output([*root, "rm", "--recursive", "--force", "--one-file-system", folder], timeout=REMOVAL_SECONDS)
    return not path.exists()
