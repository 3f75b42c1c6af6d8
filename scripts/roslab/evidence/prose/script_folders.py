"""The folder that a script goes to or reads: that of its author's computer, or one above its own."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_GOES = pattern(r"^cd[ \t]+[\"']?([^\s\"';&|]+)[\"']?[ \t]*(\|\||&&)?", re.MULTILINE)
_SOURCES = pattern(
    r"^(?:source|\.)[ \t]+[\"']?(/(?:home|Users)/[A-Za-z][\w.-]*/[^\s\"';&|]*/conda\.sh)[\"']?[ \t]*(\|\||&&)?",
    re.MULTILINE,
)
"""A conda in somebody's home."""
_HOME = pattern(r"/(?:home|Users)/[A-Za-z][\w.-]*(?:/[\w.-]+)+/?")
_READS = pattern(
    r"^(?P<main>[ ]{4})?\w+[ \t]*=[ \t]*[\"']/(?:home|media|Users)/[A-Za-z][\w.-]*/[^\"'\n]+[\"'][ \t]*(?:#.*)?$",
    re.MULTILINE,
)
"""A line of Python that names a folder of its author's computer."""
_MAIN = pattern(r"^if __name__ ==", re.MULTILINE)
_ABOVE = pattern(r"\.\.(?:/\.\.)*/?")
_STOPS = pattern(r"^set[ \t]+-\w*e", re.MULTILINE)
"""The script ends where a command fails."""
_STARTS = pattern(
    r"^[ \t]*(?:\w+=\S*[ \t]+)*(?:python[\d.]*|(?:ba)?sh|source|\.)[ \t]+(?:-u[ \t]+)?"
    r"((?:[\w-]+/)*[\w-]+\.(?:py|sh))(?=\s|$)",
    re.MULTILINE,
)
"""A line that starts a script by a path which begins nowhere."""
_PROGRAM = pattern(r"(?:^|\s)((?:[\w-]+/)*[\w-]+\.(?:py|sh))(?=\s|$)", re.MULTILINE)


def elsewhere(mention: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield the script that a command of a page runs, if it cannot do without a folder of its author's computer.

    A shell script goes there, or sources a conda there, and ends where that is not. One of Python has it written down,
    and is given nothing.
    """
    words = mention.value.split()
    if len(words) == 2 and words[0].startswith("python") and words[1].endswith(".py") and repository.has(words[1]):
        if _reads(repository.read(words[1], limit=MAX_SIZE)):
            yield replace(mention, topic="elsewhere", value=words[1])
        return
    script = _script(words, repository)
    text = repository.read(script, limit=MAX_SIZE) if script else ""
    goes = _GOES.search(text)
    goes = goes if goes and _HOME.fullmatch(goes[1]) else None
    if any(each and (each[2] or _STOPS.search(text, 0, each.start())) for each in (goes, _SOURCES.search(text))):
        yield replace(mention, topic="elsewhere", value=script)


def _reads(text: str) -> bool:
    """Tell whether a file of Python names such a folder for all of it, or where it is started."""
    guard = _MAIN.search(text)
    return any(not found["main"] or (guard and found.start() > guard.start()) for found in _READS.finditer(text))


def started_above(words: Sequence[str], repository: Repository) -> str:
    """Return the folder of a shell script that begins with ``cd ..`` and starts what lies there; else ``""``."""
    script = _script(words, repository)
    folder = posixpath.dirname(script)
    text = repository.read(script, limit=MAX_SIZE) if folder else ""
    goes = _GOES.search(text)
    if not goes or not _ABOVE.fullmatch(goes[1]):
        return ""
    above = posixpath.normpath(posixpath.join(folder, goes[1]))
    started = (posixpath.normpath(posixpath.join(above, name)) for name in _PROGRAM.findall(text, goes.end()))
    return folder if any(map(repository.has, started)) else ""


def started_beside(words: Sequence[str], repository: Repository) -> str:
    """Return the folder of a shell script that goes nowhere and starts what lies there, and nowhere else; else ``""``.

    A command that gives it a path from the root is meant to be run there.
    """
    script = _script(words, repository)
    folder = posixpath.dirname(script)
    text = repository.read(script, limit=MAX_SIZE) if folder else ""
    started = [] if not text or _GOES.search(text) else _STARTS.findall(text)
    if not started or any(map(repository.has, (*started, *(word for word in words if word != script)))):
        return ""
    return folder if all(repository.has(posixpath.join(folder, each)) for each in started) else ""


def _script(words: Sequence[str], repository: Repository) -> str:
    """Return the shell script that a command starts, with its path from the root, ``""`` where it starts none."""
    place = 1 if words[0] in {"bash", "sh"} else 0
    return next(
        (word for word in words[place : place + 1] if word.endswith(SHELL_SCRIPTS) and repository.has(word)), ""
    )
