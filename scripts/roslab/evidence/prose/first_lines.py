"""Programs that pages run and whose first line names what starts them: ``#!/usr/bin/screen -c``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.ros.launch import names_by_folder
from roslab.knowledge.compiled import programs
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

ROLE = "first_line"
FIRST_LINE = pattern(r"#![ \t]*(?:\S{0,200}/)?(?:env[ \t]+(?:-S[ \t]+)?(?:\S{0,200}/)?)?([\w.+-]+)")
"""The first line of a script, with the name of the program that starts it."""
_LONGEST = 200
"""Bytes that are read for a first line."""
_RUN = pattern(r"(?:rosrun|ros2 run) ([a-z]\w{0,60}) ([A-Za-z][\w.-]{0,80})(?= |$)")
_EVERYWHERE = pattern(r"(?:ba|da)?sh|env|perl|i?python[\d.]*")
"""What every image has, or what has it depends on the Python that is taken."""


def read(repository: Repository, said: Iterable[Mention]) -> Iterator[Dependency]:
    """Yield the package of apt with each such program, once for a file."""
    commands = [mention for mention in said if mention.topic == "command" and mention.source == "readme"]
    for file in dict.fromkeys(file for mention in commands for file in _files(mention, repository)):
        if not repository.has(file) or places.vendored(file):
            continue
        match = FIRST_LINE.match(repository.read_bytes(file, limit=_LONGEST).decode("latin-1"))
        if match and match[1] in programs() and not _EVERYWHERE.fullmatch(match[1]):
            name = programs()[match[1]]
            yield Dependency(namespace="apt", name=name, strength="used", file=file, line=1, role=ROLE)


def _files(mention: Mention, repository: Repository) -> Iterator[str]:
    """Yield the file that a command starts by its path, or the one of its package that ``rosrun`` finds by its name."""
    program = mention.value.partition(" ")[0].rpartition("/")[2]
    yield from (file for file in mention.files if file.rpartition("/")[2] == program)
    if found := _RUN.match(mention.value):
        package, program = found.groups()
        folders = tuple(f"{folder}/" for folder, name in repository.once(names_by_folder).items() if name == package)
        named = [file.path for file in repository.named(program) if f"{file.folder}/".startswith(folders)]
        yield from named if len(named) == 1 else ()
