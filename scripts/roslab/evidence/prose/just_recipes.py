"""What a shell runs for a call of ``just``: the lines of the recipe."""

from __future__ import annotations

import shlex
from functools import partial

from roslab.evidence.lex.justfile import Justfile, parsed
from roslab.evidence.prose.task_calls import TaskCalls, joined
from roslab.repository.checkout import Repository, nearest

NAMES = ("justfile", "Justfile", ".justfile")
MAX_SIZE = 128 * 1024
MOST_FILES = 60
"""Most justfiles, those nearest to the root first."""
WORDS = r"just[ \t]+([A-Za-z_][\w-]*(?:[ \t]+[^\s#;&|`<>$]+){0,8})"


def calls(repository: Repository) -> dict[str, TaskCalls]:
    """Return what the justfiles in the folders of a tree define."""
    return repository.once(_justfiles)


def _justfiles(repository: Repository) -> dict[str, TaskCalls]:
    by_folder = {file.folder: file for file in repository.named(*NAMES)}
    files = nearest(by_folder.values())[:MOST_FILES]
    found = {file.folder: parsed(repository.read(file, limit=MAX_SIZE)) for file in files}
    return {folder: TaskCalls(partial(_run, justfile)) for folder, justfile in found.items()}


def _run(found: Justfile, call: str) -> str | None:
    try:
        name, *given = shlex.split(call)
    except ValueError:
        return None
    return joined(found.lines_of(name, given) or ())
