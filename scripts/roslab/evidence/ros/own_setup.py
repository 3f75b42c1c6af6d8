"""Scripts of the tree that take the repository's folder for the workspace: ``source "$here/install/setup.bash"``.

Others take the folder above it: ``source "$here/../devel/setup.bash"``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MOST = 40
"""Scripts that are read."""
_SETUP = r"((?:/\.\.)*)/(install|devel)/(?:local_)?setup\.(?:ba|z)?sh\b"
_SOURCED = pattern(rf"^[ \t]*(?:source|\.)[ \t]+[\"']?\$\{{?(\w+)\}}?[\"']?{_SETUP}", re.MULTILINE)
_IN_PYTHON = pattern(
    rf"^[^#\n]*\b(?:source|\.)[ \t]+(?:\{{(\w*)\}}|[\"'][ \t]*\+[ \t]*(\w+)[ \t]*\+[ \t]*[\"']){_SETUP}[^\n]*",
    re.MULTILINE,
)
"""A command that Python hands to a shell, with the folder in braces, or put in between."""
_ITSELF = pattern(r"^[ \t]*(?:readonly[ \t]+|export[ \t]+)?(\w+)=([^\n]*(?:BASH_SOURCE|\$\{?0\b)[^\n]*)$", re.MULTILINE)
"""A variable that is set to the folder of the script, or one above it."""
_OF_PYTHON = pattern(r"^(\w+)[ \t]*=([^\n]*\b__file__\b[^\n]*)$", re.MULTILINE)
_WORD = pattern(r"\w+")
_UP = pattern(r"\bdirname\(|\.parent\b(?!s)|/\.\.(?![\w.])|[\"']\.\.[\"']")
_ABOVE = pattern(r"/\.\.(?![\w.])")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such script for each of the folders that a build tool writes, if the repository has none.

    The value is ``install`` or ``devel``, with ``../`` before it where the folder above the repository's is meant.
    """
    told = {name for name in ("install", "devel") if any(f.path.startswith(f"{name}/") for f in repository.files)}
    for file in (*_nearest(repository, ".sh", ".bash"), *_nearest(repository, ".py")):
        text = repository.read(file, limit=MAX_SIZE)
        for match, named in _sourced(file.path, text) if "/setup." in text else ():
            if named and named not in told:
                told.add(named)
                line = text.count("\n", 0, match.start(1)) + 1
                said = match[0].strip()
                yield Mention(topic="own_setup", value=named, source="script", file=file.path, line=line, text=said)


def _nearest(repository: Repository, *suffixes: str) -> list[File]:
    return nearest(file for file in repository.suffixed(*suffixes) if not places.vendored(file.path))[:MOST]


def _sourced(file: str, text: str) -> Iterator[tuple[re.Match[str], str]]:
    """Yield each line that sources a setup script, with its folder; ``""`` for one that is not of the repository."""
    depth = file.count("/")
    if file.endswith(".py"):
        folders = {match[1]: len(_UP.findall(match[2])) - 1 for match in _OF_PYTHON.finditer(text)}
        for match in _IN_PYTHON.finditer(text) if folders else ():
            words = {*_WORD.findall(match[0])}
            name = match[1] or match[2] or next((each for each in folders if each in words), "")
            up = folders.get(name, -1) + len(_ABOVE.findall(match[3]))
            yield match, f"../{match[4]}" if name in folders and up == depth + 1 else ""
        return
    for match in _SOURCED.finditer(text):
        up = len(_ABOVE.findall(match[2]))
        inside, above = of_root(text, match[1], depth - up), of_root(text, match[1], depth + 1 - up)
        yield match, match[3] if inside else f"../{match[3]}" if above else ""


def of_root(text: str, name: str, depth: int) -> bool:
    """Tell whether a variable names the folder that lies so many folders above the script's own."""
    return _folders_above(text).get(name) == depth


@lru_cache(maxsize=4)
def _folders_above(text: str) -> dict[str, int]:
    """Return the variables that are first set to the folder of a script or one above it, with by how many above."""
    found: dict[str, int] = {}
    for name, value in _ITSELF.findall(text):
        found.setdefault(name, len(_ABOVE.findall(value)))
    return found
