"""The folder that a shell script goes to at its beginning: that of its author's computer, or one above its own."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_GOES = pattern(r"^cd[ \t]+[\"']?([^\s\"';&|]+)[\"']?[ \t]*(\|\||&&)?", re.MULTILINE)
_HOME = pattern(r"/(?:home|Users)/[A-Za-z][\w.-]*(?:/[\w.-]+)+/?")
_ABOVE = pattern(r"\.\.(?:/\.\.)*/?")
_STOPS = pattern(r"^set[ \t]+-\w*e", re.MULTILINE)
"""The script ends where a command fails."""
_PROGRAM = pattern(r"(?:^|\s)((?:[\w-]+/)*[\w-]+\.(?:py|sh))(?=\s|$)", re.MULTILINE)


def elsewhere(mention: Mention, repository: Repository) -> Iterator[Mention]:
    """Yield the shell script that a command of a page runs, if it goes to its author's folder and ends without it."""
    script = _script(mention.value.split(), repository)
    text = repository.read(script, limit=MAX_SIZE) if script else ""
    goes = _GOES.search(text)
    if goes and _HOME.fullmatch(goes[1]) and (goes[2] or _STOPS.search(text, 0, goes.start())):
        yield replace(mention, topic="elsewhere", value=script)


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


def _script(words: Sequence[str], repository: Repository) -> str:
    """Return the shell script that a command starts, with its path from the root, ``""`` where it starts none."""
    place = 1 if words[0] in {"bash", "sh"} else 0
    return next((word for word in words[place : place + 1] if word.endswith(".sh") and repository.has(word)), "")
