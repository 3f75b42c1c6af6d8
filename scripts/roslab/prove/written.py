"""What a program wrote during its proof: figures and result files in the container that are new and not empty."""

from __future__ import annotations

import io
import subprocess
import tarfile
from contextlib import suppress

from roslab.engine.docker import output
from roslab.knowledge.results import result_of

MOST = 20
"""Most files that are looked at; a program may write one for each frame."""


def results(container: str) -> tuple[str, ...]:
    """Return the paths of a container's new result files, sorted; none if the engine does not tell."""
    answer = output(["docker", "diff", container])
    new = [line[2:] for line in answer.stdout.splitlines() if line.startswith("A ")]
    found = sorted(path for path in new if result_of(path) and path.isprintable())[:MOST]
    return tuple(path for path in found if _size(container, path))


def _size(container: str, path: str) -> int:
    """Return the bytes of a file in a container, 0 for a folder, a link or one that cannot be read."""
    command = ["docker", "cp", f"{container}:{path}", "-"]
    with (
        suppress(OSError, tarfile.TarError),
        subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        ) as process,
    ):
        head = process.stdout.read(4096) if process.stdout else b""
        process.kill()
        with tarfile.open(fileobj=io.BytesIO(head), mode="r:") as archive:
            entry = archive.next()
            return entry.size if entry and entry.isfile() else 0
    return 0
