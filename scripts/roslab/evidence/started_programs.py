"""Programs for a person at a terminal that the tree starts all the same: ``tmux new -d``, ``#!/usr/bin/env zsh``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.called_in_scripts import MAX_SIZE, calls_of
from roslab.evidence.prose.first_lines import FIRST_LINE
from roslab.evidence.python.called import programs_of
from roslab.evidence.python.modules import modules
from roslab.knowledge.authors_own import authors_own
from roslab.repository.checkout import Repository, nearest

MAX_FILES = 200
"""Most scripts that are searched, those nearest to the root first."""
_SCRIPTS = (".sh", ".bash", ".zsh")


def read(repository: Repository) -> tuple[Mention, ...]:
    """Return where scripts and Python code start what a table takes for its author's own, each program once."""
    found: dict[str, Mention] = {}
    for name, file, line in (*_of_scripts(repository), *_of_python(repository)):
        if authors_own(ros=False).match(name) and name not in found:
            found[name] = Mention(topic="started", value=name, source="script", file=file, line=line, text=name)
    return tuple(found.values())


def _of_scripts(repository: Repository) -> Iterator[tuple[str, str, int]]:
    scripts = (file for file in repository.suffixed(*_SCRIPTS) if not places.vendored(file.path))
    for file in nearest(scripts)[:MAX_FILES]:
        text = repository.read(file, limit=MAX_SIZE)
        if match := FIRST_LINE.match(text):
            yield match[1], file.path, 1
        yield from ((name, file.path, line) for name, line in calls_of(text))


def _of_python(repository: Repository) -> Iterator[tuple[str, str, int]]:
    for module in modules(repository):
        yield from ((name, module.file.path, line) for name, line in programs_of(module))
