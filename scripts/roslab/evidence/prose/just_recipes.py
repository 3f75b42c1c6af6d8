"""What a shell runs for a call of ``just``: the lines of the recipe."""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence

from roslab.evidence.lex.justfile import Justfile, parsed
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

NAMES = ("justfile", "Justfile", ".justfile")
MAX_SIZE = 128 * 1024
MOST_CALLS = 500
"""Most different calls of one justfile of which the lines are looked up."""
MOST_FILES = 60
"""Most justfiles, those nearest to the root first."""
WORDS = r"just[ \t]+([A-Za-z_][\w-]*(?:[ \t]+[^\s#;&|`<>$]+){0,8})"
_ENTERS = pattern(r"(?:^|[;&|][ \t]*)(?:cd|pushd)\b")


class JustCalls:
    """The recipes of one justfile, with what each call of them runs, which is found once for all pages."""

    def __init__(self, found: Justfile) -> None:
        self._found = found
        self._known: dict[str, str | None] = {}

    def line_of(self, call: str) -> str | None:
        """Return the lines of the recipe that is called, joined; ``None`` where they are not known."""
        if call not in self._known:
            if len(self._known) >= MOST_CALLS:
                return None
            self._known[call] = _joined(call, self._found)
        return self._known[call]


def calls(repository: Repository) -> dict[str, JustCalls]:
    """Return what the justfiles in the folders of a tree define."""
    return repository.once(_justfiles)


def _justfiles(repository: Repository) -> dict[str, JustCalls]:
    """Return what the justfiles in the folders of a tree define."""
    by_folder = {file.folder: file for file in repository.named(*NAMES)}
    files = nearest(by_folder.values())[:MOST_FILES]
    return {file.folder: JustCalls(parsed(repository.read(file, limit=MAX_SIZE))) for file in files}


def _joined(call: str, found: Justfile) -> str | None:
    try:
        name, *given = shlex.split(call)
    except ValueError:
        return None
    return joined(found.lines_of(name, given) or ())


def joined(lines: Sequence[str]) -> str | None:
    """Return the lines of a task on one, each that goes to a folder in a shell of its own; ``None`` for none."""
    if not lines or any("`" in line for line in lines):
        return None
    whole = ""
    for line in lines:  # just runs each in a shell of its own
        alone = f"({line})" if len(lines) > 1 and _ENTERS.search(line) else line
        whole += ("" if not whole else " " if re.search(r"(?<!&)&$", whole) else " && ") + alone
    return whole
