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

_INIT, _ADD = ("init", "--quiet"), ("add", "--all")
_COMMIT = ("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "--quiet", "--message", "all")

_NAMED = "<package{}><name>demo</name><buildtool_depend>{}</buildtool_depend>{}</package>"
HUMBLE = {
    "package.xml": _NAMED.format(' format="3"', "ament_cmake", "<export><build_type>ament_cmake</build_type></export>"),
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
    "README.md": "For ROS Humble.\n",
}
"""A package of ROS 2 without a program."""
NOETIC = {
    "package.xml": _NAMED.format("", "catkin", ""),
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "README.md": "For ROS Noetic.\n",
}
"""A package of ROS 1 without a program."""


def tree_of(folder: Path, files: dict[str, str]) -> Repository:
    """Write files, by their paths below a folder, and open the folder."""
    for path, text in files.items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return Repository.open(folder)


def decided(
    folder: Path, files: dict[str, str], day: str = "", config: Config | None = None, branch: str | None = None
) -> Decision:
    """Write files and return what is decided about them: their last commit is of a day, ``""`` for none at all."""
    tree_of(folder, files)
    evidence = gather(Repository.open(folder, branch=branch))
    date = Mention(topic="date", value=day, source="commit", file=".git/HEAD", line=1, text=day)
    mentions = (*evidence.mentions, date) if day else evidence.mentions
    return decide(replace(evidence, mentions=mentions), config or Config(), folder_name="demo")


def commit(folder: Path, day: str) -> None:
    """Make a folder a repository of git with all its files in one commit, at noon of a day (``YYYY-MM-DD``)."""
    when = dict.fromkeys(("GIT_AUTHOR_DATE", "GIT_COMMITTER_DATE"), f"{day}T12:00:00Z")
    _git(folder, _INIT, _ADD, _COMMIT, **when)


def linked(folder: Path, files: dict[str, str], commit: str, *paths: str) -> None:
    """Write files as one commit of git that has submodules at these paths, which are not there, at another commit."""
    tree_of(folder, files)
    links = (("update-index", "--add", "--cacheinfo", f"160000,{commit},{path}") for path in paths)
    _git(folder, _INIT, _ADD, *links, _COMMIT)


def _git(folder: Path, *calls: tuple[str, ...], **environment: str) -> None:
    for words in calls:
        subprocess.run(
            ["git", "-C", folder, *words], check=True, env={**environment, "HOME": str(folder), "PATH": "/usr/bin:/bin"}
        )
