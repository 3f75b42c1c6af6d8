"""What a container of an author's own image starts by itself, and what it can be given where that is a shell."""

from __future__ import annotations

import posixpath
import re
import shlex
from typing import Literal

from roslab.decide.candidate import Candidate, is_python, program_of, there
from roslab.evidence.entry_script import Taken
from roslab.evidence.facts import AuthorDockerfile
from roslab.knowledge.distros import codename_of
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

EntryPoint = Literal["none", "wrapper", "shell", "program"]
"""A ``wrapper`` sets something up and starts what it is given."""
_SHELLS = frozenset({"bash", "sh", "zsh", "dash", "fish"})
_WAITS = frozenset({"tail", "sleep", "tmux", "screen", "terminator", "xterm", "byobu", "roscore"})
"""Programs that keep a container open for a person, or for the nodes that are started in it."""
_INITS = frozenset({"tini", "dumb-init", "docker-init", "env", "gosu"})
_RUNNERS = frozenset({"conda", "mamba", "micromamba"})
_START_SHELLS = ("debian:", "osrf/", "nvidia/", "nvcr.io/", "pytorch/", "continuumio/", "mambaorg/", "condaforge/")
"""Beginnings of the names of images that start a shell, through an entry point that sets something up."""
_WRAPPER = pattern(r"entry[-_]?point|^ros_entry", re.IGNORECASE)
_OF_ROS = frozenset({"roslaunch", "rosrun", "ros2"})
_LAST = pattern(r"&&|\|\||;|\n")


def started(authored: AuthorDockerfile) -> tuple[str, ...]:
    """Return the program that a container starts by itself, ``()`` for a shell.

    An ENTRYPOINT leaves nothing of its base's CMD: its script is given no words where the Dockerfile has no CMD.
    https://docs.docker.com/reference/dockerfile/#understand-how-cmd-and-entrypoint-interact, read 2026-11-29.
    """
    entry, command = authored.entrypoint, _command(authored)
    if entry_point_of(authored) == "program":
        return entry if taken_by(authored) == "nothing" or idle(command) else (*entry, *command)
    if not command and authored.entry and authored.entry.alone and entry_point_of(authored) == "wrapper":
        return entry
    return () if idle(command) else command


def left_to_base(authored: AuthorDockerfile) -> bool:
    """Tell whether a base says what a container starts, and it is no system, whose images start a shell."""
    own = authored.command or authored.entrypoint or (authored.service and authored.service.command)
    base = authored.base or ""
    return not own and codename_of(base) is None and not base.startswith(_START_SHELLS)


def of_system(base: str) -> bool:
    """Tell whether a base is a system, or one with tools for everybody: it has no program of the repository."""
    return base.startswith(_START_SHELLS) or ("/" not in base and codename_of(base) is not None)


def composed(authored: AuthorDockerfile) -> tuple[str, ...]:
    """Return what a container is given where Docker Compose starts another command, or sets variables; else ``()``."""
    service, argv = authored.service, started(authored)
    if service is None or not argv or (idle(service.command) and not service.environment):
        return ()
    variables = tuple(f"{name}={value}" for name, value in service.environment)
    return ("env", *variables, *argv) if variables else argv


def _command(authored: AuthorDockerfile) -> tuple[str, ...]:
    """Return the program that Docker Compose gives a container, else the CMD: one that only waits leaves that alone."""
    given = authored.service.command if authored.service else ()
    return authored.command if idle(given) else given


def startable(candidate: Candidate, authored: AuthorDockerfile) -> bool:
    """Tell whether a container that only starts a shell can be given a command.

    A program of ROS is found by its package, a compiled one by its name; a file of the tree only where the folder that
    the tree was copied to is known.
    """
    if entry_point_of(authored) == "program" or started(authored):
        return False
    in_tree = candidate.argv[0].startswith("python") or candidate.argv[0] in _SHELLS
    in_tree = in_tree or not {*candidate.files}.isdisjoint(candidate.argv[len(program_of(candidate.argv)) :])
    return not in_tree or bool((authored.starts_in_source or authored.source) and not authored.context)


def there_in(candidate: Candidate, authored: AuthorDockerfile) -> bool:
    """Tell whether an image may have the script that a command starts: of the tree it may have only some parts.

    Docker Compose may mount others.
    """
    script = program_of(candidate.argv)[-1]
    of_tree = candidate.argv[0] in _SHELLS or is_python(candidate)
    if authored.kept is None or not (of_tree and script.endswith((".py", *SHELL_SCRIPTS))):
        return True
    mounted = [host for host, _, _ in authored.service.volumes] if authored.service else []
    return any(f"{script}/".startswith(f"{part}/") for part in (*authored.kept, *mounted))


def folder_of(candidate: Candidate, authored: AuthorDockerfile) -> str:
    """Return the folder to go to for a script of the tree, ``""`` where a container starts in it."""
    script = candidate.argv[0] in _SHELLS or is_python(candidate)
    if not script or authored.context or not (authored.source or authored.starts_in_source):
        return candidate.inside
    folder = posixpath.normpath(posixpath.join(authored.source or ".", candidate.inside))
    return "" if folder == "." else folder


def given(candidate: Candidate, authored: AuthorDockerfile) -> tuple[str, ...]:
    """Return a command with the files of the tree that a node is given by their paths from where a container starts."""
    if candidate.argv[0] not in _OF_ROS or not authored.source:
        return candidate.argv
    named = program_of(candidate.argv)
    words = candidate.argv[len(named) :]
    inside = (posixpath.normpath(posixpath.join(authored.source, w)) if w in candidate.files else w for w in words)
    return (*named, *inside)


def listed_in(candidate: Candidate, authored: AuthorDockerfile) -> tuple[str, ...]:
    """Return a command as a container of the image takes it: with the tree's files, or in its folder for a script."""
    folder = folder_of(candidate, authored)
    script = candidate.argv[0] in _SHELLS or is_python(candidate)
    return ("bash", "-c", there(candidate, folder)) if script and folder else given(candidate, authored)


def entry_point_of(authored: AuthorDockerfile) -> EntryPoint:
    """Return what the ENTRYPOINT of a Dockerfile does, by the text of its script where the tree has it."""
    if (entry := authored.entry) is None or _started_by_script(authored):
        return entry_point(authored.entrypoint)
    if entry.takes == "nothing":
        return "shell" if entry.shell else "program"
    return "wrapper" if entry.takes == "commands" else entry_point(authored.entrypoint)


def taken_by(authored: AuthorDockerfile) -> Taken:
    """Return what becomes of the words behind the image's name: a line of ``sh -c`` without ``$@`` never sees them."""
    entry = authored.entrypoint
    if entry_point_of(authored) in {"none", "wrapper"}:
        return "commands"
    if authored.entry and not _started_by_script(authored):
        return authored.entry.takes
    return "nothing" if _name(entry[0]) in _SHELLS and any(_runs(word) for word in entry[1:]) else "arguments"


def _started_by_script(authored: AuthorDockerfile) -> bool:
    """Tell whether the ENTRYPOINT stands for the program that its script hands all arguments to."""
    return authored.entry is not None and not authored.entrypoint[-1].endswith(posixpath.basename(authored.entry.file))


def entry_point(argv: tuple[str, ...]) -> EntryPoint:
    """Return what an ENTRYPOINT does with the command that it is given."""
    if not argv:
        return "none"
    name = _name(argv[0])
    rest = tuple(word for word in argv[1:] if not word.startswith("-"))
    if name in _INITS:
        return entry_point(rest) if rest else "wrapper"
    if name in _RUNNERS and rest[:1] == ("run",):
        return "wrapper"
    if name in _SHELLS and argv[1:2] == ("-c",) and "$@" in " ".join(argv[2:]):
        return "wrapper"
    if idle(argv):
        return "shell"
    script = rest[0] if name in _SHELLS and rest else argv[0]
    return "wrapper" if _WRAPPER.search(_name(script)) else "program"


def idle(argv: tuple[str, ...]) -> bool:
    """Tell whether a command is a shell or waits for one; ``bash -c "source setup.bash && bash"`` is."""
    if not argv:
        return True
    name = _name(argv[0])
    if name in _SHELLS and (text := next((argv[i + 1 :][0] for i, w in enumerate(argv[:-1]) if _runs(w)), "")):
        last = [part for part in _LAST.split(text) if part.strip()]
        try:
            words = shlex.split(last[-1]) if last else []
        except ValueError:
            return False
        words = words[1:] if words[:1] == ["exec"] else words
        return not words or (words[0] != "source" and words[0] != "." and idle(tuple(words)))
    if name in _WAITS:
        return True
    return name in _SHELLS and all(word.startswith("-") for word in argv[1:])


def _runs(word: str) -> bool:
    """Tell whether a word is the option of a shell that a text follows: ``-c``, ``-lc``."""
    return word.startswith("-") and not word.startswith("--") and word.endswith("c")


def _name(path: str) -> str:
    return path.rpartition("/")[2]
