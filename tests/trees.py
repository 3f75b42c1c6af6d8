"""Small trees that tests write and open as repositories."""

from __future__ import annotations

import subprocess
from dataclasses import replace
from pathlib import Path

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository


def tree_of(folder: Path, files: dict[str, str]) -> Repository:
    """Write files, by their paths below a folder, and open the folder."""
    for path, text in files.items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return Repository.open(folder)


def decided(folder: Path, files: dict[str, str], day: str = "", config: Config | None = None) -> Decision:
    """Write files and return what is decided about them: their last commit is of a day, ``""`` for none at all."""
    evidence = gather(tree_of(folder, files))
    date = Mention(topic="date", value=day, source="commit", file=".git/HEAD", line=1, text=day)
    mentions = (*evidence.mentions, date) if day else evidence.mentions
    return decide(replace(evidence, mentions=mentions), config or Config(), folder_name="demo")


def commit(folder: Path, day: str) -> None:
    """Make a folder a repository of git with all its files in one commit, at noon of a day (``YYYY-MM-DD``)."""
    when = dict.fromkeys(("GIT_AUTHOR_DATE", "GIT_COMMITTER_DATE"), f"{day}T12:00:00Z")
    who = ("-c", "user.name=a", "-c", "user.email=a@example.org")
    for words in (("init", "--quiet"), ("add", "--all"), (*who, "commit", "--quiet", "--message", "all")):
        subprocess.run(
            ["git", "-C", folder, *words], check=True, env={**when, "HOME": str(folder), "PATH": "/usr/bin:/bin"}
        )
