"""Folders of the tree that a page puts on PYTHONPATH."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.repository.checkout import File, Repository
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

DEEPEST = 1
"""A page below is about a part."""
_SET = pattern(r"\bPYTHONPATH=([^\n#`]{1,300})")
_END = pattern(r"[\"'\s]")
_TO = pattern(r"^(?:path[_-]?to|your)[_-]", re.IGNORECASE)
"""What a page writes before the name of the folder: ``PATH_TO_DEMO``."""
HERE = pattern(r"^(?:\.|\./|\$\(pwd\)|\$\{?PWD\}?)$")


def read(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    """Yield each folder, ``.`` for the root; what ends with neither a folder of the tree nor its name is another's."""
    if "PYTHONPATH=" not in text or file.path.count("/") > DEEPEST:
        return
    text = text.replace("`pwd`", "$(pwd)")
    for match in _SET.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        value = match[1].lstrip("\"'")
        said = _END.split(value, maxsplit=1)[0] if "<" not in value else value.replace(" ", "")
        for part in said.split(":"):
            folder = folder_of(part.strip("\"'<>"), repository)
            if folder:
                yield Mention(
                    topic="python_path", value=folder, source="readme", file=file.path, line=line, text=match[0][:80]
                )


def folder_of(path: str, repository: Repository) -> str:
    """Return the folder of the tree that a path ends with, ``.`` for the root, ``""`` for none."""
    if HERE.match(path):
        return "."
    parts = [part for part in path.rstrip("/").split("/") if part not in {"", "."}]
    tails = ("/".join(parts[start:]) for start in range(len(parts)))
    itself = "." if parts and bare_name(_TO.sub("", parts[-1])) == bare_name(repository.name) else ""
    found = next((tail for tail in tails if tail in repository.folders), itself)
    return "." if itself and found == parts[-1] and _clone(parts, repository) else found


def _clone(parts: list[str], repository: Repository) -> bool:
    """Tell whether the last part of a path, the repository's name and a folder of the tree, is the clone's folder.

    It is where a reader's own folders stand before it, not its name again, and where the folder is a package: its
    modules are imported by its name, and on the path itself they would hide Python's own.
    """
    elsewhere = len(parts) > 1 and not HERE.match(parts[0]) and parts[-2] != parts[-1]
    return elsewhere or repository.has(f"{parts[-1]}/__init__.py")
