"""Small trees that tests write and open as repositories."""

from __future__ import annotations

import subprocess
from pathlib import Path

from roslab.repository.checkout import Repository


def tree_of(folder: Path, files: dict[str, str]) -> Repository:
    """Write files, by their paths below a folder, and open the folder."""
    for path, text in files.items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return Repository.open(folder)


def commit(folder: Path, day: str) -> None:
    """Make a folder a repository of git with all its files in one commit, at noon of a day (``YYYY-MM-DD``)."""
    when = dict.fromkeys(("GIT_AUTHOR_DATE", "GIT_COMMITTER_DATE"), f"{day}T12:00:00Z")
    who = ("-c", "user.name=a", "-c", "user.email=a@example.org")
    for words in (("init", "--quiet"), ("add", "--all"), (*who, "commit", "--quiet", "--message", "all")):
        subprocess.run(
            ["git", "-C", folder, *words], check=True, env={**when, "HOME": str(folder), "PATH": "/usr/bin:/bin"}
        )
