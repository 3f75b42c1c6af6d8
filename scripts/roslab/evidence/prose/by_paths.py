"""Where a program is started that a page calls by its name in one place (``train.py``), and by its path in another."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.values.dataclass import replace


def started_by_paths(told: Iterable[Mention], written: Iterable[Mention]) -> Iterator[Mention]:
    """Yield what a page tells, each program that it starts by its path from the root elsewhere without a folder.

    ``written``: the same before the files of the tree were looked for, which tells where the page goes itself.
    """
    found = tuple(told)
    apart = [each for each in found if each.topic == "command" and each.inside]
    gone = {(each.file, each.line, each.text) for each in written if each.inside} if apart else set()
    by_path = {path for each in found if each.topic == "command" and not each.inside for path in _by_path(each)}
    for each in found:
        bare = each in apart and (each.file, each.line, each.text) not in gone and each.files[:1]
        yield replace(each, inside="") if bare and each.files[0] in by_path else each


def _by_path(command: Mention) -> Iterator[str]:
    """Yield the program that a command of Python's names by its whole path from the root."""
    words = {posixpath.normpath(word) for word in command.text.split()}
    program = command.files[0] if command.files and command.value.startswith("python") else ""
    if "/" in program and program.endswith(".py") and program in words:
        yield program
