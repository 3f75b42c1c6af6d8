"""The artifacts of a run under act, wherever they are kept: the stand-in's folder, or act's own server."""

from __future__ import annotations

import zipfile
from pathlib import Path


def artifacts(place: Path) -> dict[str, bytes]:
    """Return the files of a run's artifacts, ARTIFACT/FILE, from the stand-in's folder and from act's own server."""
    found = {}
    for file in sorted((place / "artifacts").rglob("*")):
        if file.is_file() and not file.name.startswith("."):  # the stand-in's own notes
            found[str(file.relative_to(place / "artifacts"))] = file.read_bytes()
    for archive in sorted((place / "act-artifacts").rglob("*.zip")):
        with zipfile.ZipFile(archive) as opened:
            found |= {f"{archive.stem}/{name}": opened.read(name) for name in opened.namelist()}
    return found
