"""Distributions in names: of the branch, and of files (``Dockerfile.noetic``, ``foxy.repos``)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.knowledge.distros import distros, english_words, ever
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_WORD = pattern(r"[a-z]+[0-9]*|[0-9.]+")
_ANYTHING = (".yaml", ".yml", ".sh")
_FILES = pattern(r"dockerfile|containerfile|\.repos$|\.rosinstall$|\.repos\.ya?ml$|docker-compose|\.ya?ml$|\.sh$")


def read(repository: Repository, others: Collection[str] = ()) -> tuple[Mention, ...]:
    """Return the distributions in the names of the branch, Dockerfiles, vcs files, CI files and scripts.

    ``others``: the files that are only for other branches, which are named after theirs.
    """
    return tuple(_branch(repository)) + tuple(_files(repository, others))


def _branch(repository: Repository) -> Iterator[Mention]:
    branch = repository.branch
    if not branch:
        return
    words = _WORD.findall(branch.lower())
    for word in words:
        if word in ever():
            yield _mention(word, "branch", ".git/HEAD", branch)
    ros = next((word for word in words if word in {"ros1", "ros2"}), None)
    if ros and not any(word in distros() for word in words):
        yield _mention(ros, "branch", ".git/HEAD", branch)


def _files(repository: Repository, others: Collection[str]) -> Iterator[Mention]:
    """Read file names; if the same name without a distribution exists beside it, that one is for this branch.

    A word that names of the tree's packages begin with (``iron_x``) is the robot's in files that may be about anything.
    """
    packages = tuple(posixpath.basename(each.folder).lower() for each in repository.named("package.xml"))
    robots = {word for word in english_words() if any(name.startswith(word) for name in packages)}
    for file in repository.files:
        lower = file.name.lower()
        if not _FILES.search(lower) or places.vendored(file.path) or file.path.count("/") > 4 or file.path in others:
            continue
        for word in dict.fromkeys(_WORD.findall(lower)):
            if word not in distros() or (word in robots and lower.endswith(_ANYTHING)):
                continue
            plain = re.sub(rf"[._-]?{word}", "", file.name, flags=re.IGNORECASE)
            if not repository.has(f"{file.folder}/{plain}".lstrip("/")):
                yield _mention(word, "filename", file.path, file.name)


def _mention(value: str, source: str, file: str, text: str) -> Mention:
    return Mention(
        topic="distro", value=value, source="branch" if source == "branch" else "filename", file=file, line=1, text=text
    )
