"""Small trees that tests write and open as repositories."""

from __future__ import annotations

from pathlib import Path

from roslab.repository.checkout import Repository


def tree_of(folder: Path, files: dict[str, str]) -> Repository:
    """Write files, by their paths below a folder, and open the folder."""
    for path, text in files.items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return Repository.open(folder)
