"""The commit of a checkout, read by git without running programs that the repository's configuration names."""

from __future__ import annotations

import os
import re
from typing import TypeAlias

Root: TypeAlias = "str | os.PathLike[str]"
"""A checkout, or a folder of one."""
SECONDS = 30.0
"""Seconds that git may take: it reads one object."""
MOST_SUBJECTS = 200
"""Most commits of a file that are looked at."""
_SETTINGS = ("log.showSignature=false", "core.fsmonitor=false", "core.quotePath=true", "safe.bareRepository=explicit")
"""A folder of the tree can hold the files of a bare repository, whose configuration would then be read.
https://git-scm.com/docs/git-config#Documentation/git-config.txt-safebareRepository"""
_ENVIRONMENT = {"GIT_ALLOW_PROTOCOL": "none", "GIT_NO_LAZY_FETCH": "1", "GIT_TERMINAL_PROMPT": "0"}
"""A missing object is not fetched. https://git-scm.com/docs/git#_environment_variables"""


unanswered: set[str] = set()
"""The folders of which git did not answer in time: what it would have said is not known."""


def head(root: Root) -> tuple[str, int | None]:
    """Return the commit of a checkout and its time in seconds since 1970, ``("", None)`` if there is none."""
    answer = _read(root, "log", "-1", "--format=%H %ct")
    match = re.fullmatch(r"([0-9a-f]{40,64}) (\d+)", answer)
    return (match[1], int(match[2])) if match else ("", None)


def describe(root: Root) -> tuple[str, int] | None:
    """Return the nearest tag with a digit in it and the number of commits since, ``None`` if there is no such tag."""
    answer = _read(root, "describe", "--tags", "--long", "--match", "*[0-9]*")
    match = re.fullmatch(r"(.+)-(\d+)-g[0-9a-f]+", answer)
    return (match[1], int(match[2])) if match else None


def recorded(root: Root, paths: tuple[str, ...]) -> dict[str, str]:
    """Return the commit that the checkout's commit records for each submodule at one of the paths."""
    lines = _read(root, "ls-tree", "HEAD", "--", *paths).split("\n") if paths else []
    matches = (re.fullmatch(r"160000 commit ([0-9a-f]{40,64})\t(.+)", line) for line in lines)
    return {match[2]: match[1] for match in matches if match}


def links(root: Root) -> tuple[str, ...]:
    """Return the paths at which the checkout's commit records a commit of another repository."""
    lines = _read(root, "ls-tree", "-r", "HEAD").split("\n")
    return tuple(line.partition("\t")[2] for line in lines if line.startswith("160000 "))


def entries(root: Root) -> dict[str, str]:
    """Return the object of each file and folder right below a checkout's folder: it changes with what is in it."""
    pairs = (line.split("\t", 1) for line in _read(root, "ls-tree", "HEAD").split("\n") if "\t" in line)
    return {name: what for what, name in pairs}


def subjects(root: Root, path: str) -> tuple[str, ...]:
    """Return the subjects of the last commits that changed a file, the newest first."""
    return tuple(filter(None, _read(root, "log", f"-{MOST_SUBJECTS}", "--format=%s", "--", path).split("\n")))


def branches(root: Root) -> tuple[str, ...]:
    """Return the names of the branches that a checkout knows, those of its remotes too, each once and sorted."""
    lines = _read(root, "for-each-ref", "--format=%(refname)", "refs/heads", "refs/remotes").split("\n")
    found = (re.fullmatch(r"refs/(?:heads|remotes/[^/]+)/(.+)", line) for line in lines)
    return tuple(sorted({match[1] for match in found if match} - {"HEAD"}))


def is_tag(root: Root, name: str) -> bool:
    """Tell whether the commit of a checkout has this git tag."""
    commit = _read(root, "rev-parse", "--quiet", "--verify", f"refs/tags/{name}^{{commit}}")
    return bool(commit) and commit == head(root)[0]


def _read(root: Root, *command: str) -> str:
    """Return git's output for a checkout, ``""`` if it failed."""
    import subprocess  # noqa: PLC0415 - slow to import, and most plans need nothing of git's

    settings = [word for setting in (f"safe.directory={_top(os.fspath(root))}", *_SETTINGS) for word in ("-c", setting)]
    try:
        answer = subprocess.run(
            ["git", "--no-pager", "-C", os.fspath(root), *settings, *command],
            capture_output=True,
            stdin=subprocess.DEVNULL,
            env={**os.environ, **_ENVIRONMENT},
            text=True,
            errors="replace",
            timeout=SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        unanswered.add(os.fspath(root))
        return ""
    except OSError:  # no git on this machine
        return ""
    return answer.stdout.strip()


def _top(root: str) -> str:
    """Return the checkout that a folder is in, which git must be told to trust."""
    folder = root
    while not os.path.exists(os.path.join(folder, ".git")):  # noqa: PTH110, PTH118 - `Path` is slow to import
        above = os.path.dirname(folder) or os.curdir  # noqa: PTH120
        if above == folder:
            return root
        folder = above
    return folder
