"""An image of the engine as a compressed archive that ``docker load`` reads."""

from __future__ import annotations

import gzip
import subprocess
import tempfile
import threading
from pathlib import Path

from roslab.engine.docker import last_line, output
from roslab.errors import BuildError, Problem

SECONDS = 1800.0
CHUNK = 1024 * 1024
QUICK = 1
"""Level of compression: the highest takes five times as long and saves a tenth."""


def size(reference: str) -> int:
    """Return the bytes of an image as the engine counts them, 0 if it does not say."""
    said = output(["docker", "image", "inspect", "--format", "{{.Size}}", reference]).stdout.strip()
    return int(said) if said.isdigit() else 0


def save(reference: str, file: Path, *, most: int) -> int | None:
    """Write an image to a file and return the file's bytes, ``None`` if it would have more than ``most``.

    In that case there is no file. Raises ``BuildError`` if the engine does not give the image.
    """
    written = 0
    with (
        tempfile.TemporaryFile() as errors,
        subprocess.Popen(
            ["docker", "save", reference], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=errors
        ) as process,
    ):
        late = threading.Timer(SECONDS, process.kill)
        late.start()
        try:
            with file.open("wb") as raw:
                with gzip.GzipFile(fileobj=raw, filename="", mode="wb", compresslevel=QUICK, mtime=0) as packed:
                    while process.stdout and written <= most and (chunk := process.stdout.read(CHUNK)):
                        packed.write(chunk)
                        written = raw.tell()
                written = raw.tell()
            if written > most:
                process.kill()
            code = process.wait()
        finally:
            late.cancel()
        errors.seek(0)
        said = last_line(errors.read().decode(errors="replace"))
    if written <= most and code == 0:
        return written
    file.unlink()
    if written <= most:
        raise BuildError(Problem(message=f"the engine does not give {reference} as an archive: {said}"))
    return None
