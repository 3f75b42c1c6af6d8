"""Folders of the tree in which a page has a simulator look for its models and worlds."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.python_path import DEEPEST, folder_of
from roslab.knowledge.search_paths import search_paths
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

HERE = "./"
"""What a folder of the tree begins with in the value of a variable."""
_SET = pattern(r"\bexport[ \t]+([A-Z_]{8,40}_PATH)=([^\n#`;&]{1,300})")
_FOUND = pattern(r"\$\((?:rospack find|ros2 pkg prefix(?: --share)?|find)\s+([\w-]+)\)")
_BLANK = pattern(r"\{[A-Za-z][\w -]{0,40}\}|<[A-Za-z][\w -]{0,40}>")
"""What the reader fills in: ``{PATH ON YOUR COMPUTER}``."""
_SYSTEM = ("/opt/", "/usr/")
_END = pattern(r"[\"'\s]")


def read(repository: Repository, file: File, text: str, *, deepest: int = DEEPEST) -> Iterator[Mention]:
    """Yield each variable with the folders of the tree that its path has: ``GAZEBO_MODEL_PATH=./models``."""
    if file.path.count("/") > deepest or not any(name in text for name in search_paths()):
        return
    for match in _SET.finditer(text.replace("`pwd`", "$(pwd)")):
        value = _END.split(_BLANK.sub("…", _FOUND.sub(r"\1", match[2].lstrip("\"'"))), maxsplit=1)[0]
        parts = (part for part in value.split(":") if not part.startswith(_SYSTEM))
        folders = [folder for folder in dict.fromkeys(folder_of(part, repository) for part in parts) if folder]
        if match[1] in search_paths() and folders:
            line = match.string.count("\n", 0, match.start(1)) + 1
            yield Mention(
                topic="variable",
                value=f"{match[1]}={joined(folders)}",
                source="readme",
                file=file.path,
                line=line,
                text=re.sub(r"\s+", " ", match[0][:80]),
            )


def joined(folders: Iterable[str]) -> str:
    """Return folders of the tree, ``.`` for its root, as the value of such a variable."""
    return ":".join(HERE if folder == "." else f"{HERE}{folder}" for folder in folders)
