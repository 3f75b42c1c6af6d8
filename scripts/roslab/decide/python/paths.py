"""The folders of the tree that Python looks into: those of the author's pages, and the root where that is needed."""

from __future__ import annotations

from collections.abc import Collection

from roslab.config.model import Config, Kind
from roslab.decide.candidate import Candidate, program_of
from roslab.evidence.facts import Evidence


def python_path(
    evidence: Evidence, config: Config, kind: Kind, projects: Collection[str], command: Candidate | None
) -> tuple[str, ...]:
    """Return the folders that belong on PYTHONPATH, each once; ROS and roslab.yaml have their own.

    The root, or ``src``, is one where the default ``command``, or a program that a page nearest to the root runs,
    imports what lies there and the image installs no project of the root; ``projects`` are those that it installs, by
    their folders.
    """
    if config.compatible or kind not in {"python", "cuda"} or "PYTHONPATH" in dict(config.env):
        return ()
    said = tuple(dict.fromkeys(m.value for m in evidence.mentions if m.topic == "python_path"))
    pages = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    nearest = min((m.file.count("/") for m in pages), default=0)
    commands = [m.value.split() for m in pages if m.file.count("/") == nearest]
    commands += [list(command.argv)] if command else []
    run = {program[-1] for words in commands if (program := program_of(tuple(words)))[0] == "python3"}
    needed = (m.inside or "." for m in evidence.mentions if m.topic == "from_root" and m.file in run)
    return tuple(dict.fromkeys((*said, *needed))) if "." not in projects else said
