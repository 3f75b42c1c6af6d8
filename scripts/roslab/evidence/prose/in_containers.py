"""What a page starts in a container of its own image: ``docker run --rm demo python run.py``."""

from __future__ import annotations

import shlex
from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, logical_lines
from roslab.evidence.prose import blanks
from roslab.evidence.prose.installs import Collector
from roslab.evidence.prose.mounted_paths import of_tree
from roslab.evidence.prose.runners import by_ros
from roslab.evidence.roles import CONTAINER
from roslab.values.pattern import pattern

ENGINES = ("docker", "podman", "singularity", "apptainer")
"""What the line of a page has that starts something in a container."""
_ENGINES = frozenset({*ENGINES, "nvidia-docker", "docker-compose"})
_VERBS = frozenset({"run", "exec"})
_PYTHON = pattern(r"python[23]?(?:\.\d+)?")
_SHELL = pattern(r"(?:/bin/|/usr/bin/)?(?:ba)?sh")
_NAME = pattern(r"[\w$][\w./:${}@-]*")
"""The name of an image, a container or a service."""


def started_in(code: str, line: int, heading: str, file: str) -> tuple[Mention, ...]:
    """Return the programs that lines of a page start in containers, below a title that says so."""
    collector = Collector(file, "readme", heading=f"{heading} / {CONTAINER}")
    for start, logical in logical_lines(code, line):
        for command in commands(blanks.filled(logical, of_page=True), start):
            for inner in inside(command):
                collector.command(inner)
    return tuple(mention for mention in collector.mentions if mention.topic == "command")


def inside(command: Command) -> Iterator[Command]:
    """Yield what ``docker run``, ``docker exec`` or ``docker compose run`` starts, as far as it is Python or ROS."""
    words = command.words
    verb = next((n for n, word in enumerate(words[:4]) if word in _VERBS), 0)
    if words[0].rpartition("/")[2] not in _ENGINES or not verb:
        return
    for index in range(verb + 2, len(words)):
        before = words[index - 1]
        if before.startswith("-") or not (UNKNOWN in before or _NAME.fullmatch(before)):
            continue
        started = of_tree(words[: index - 1], words[index:])
        if text := _in_shell(started):
            yield from (inner for inner in commands(text, command.line) if is_program(inner.words))
            return
        if is_program(started):
            yield command._replace(words=started, lines=command.lines[index:])
            return


def _in_shell(words: tuple[str, ...]) -> str:
    """Return the line that a shell runs in the container, ``""`` where words start something else.

    An entry point that is a shell takes ``-c LINE``, or the line alone.
    """
    if _SHELL.fullmatch(words[0]):
        return shlex.join(words)
    if words[0] == "-c" and len(words) > 1:
        return shlex.join(("bash", *words))
    return words[0] if len(words) == 1 and " " in words[0].strip() else ""


def is_program(words: tuple[str, ...]) -> bool:
    """Tell whether words start something with Python or ROS."""
    return len(words) > 1 and (bool(_PYTHON.fullmatch(words[0])) or by_ros(words[0], words))
