"""What a shell script runs that makes a virtual environment and starts the program in it: ``./run.sh``.

The image has an environment of its own, with the project in it: the script would make another one, from the network, at
each start of a container. A script that does more than that is left as it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from roslab.evidence.prose.task_calls import TaskCalls, joined
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 8 * 1024
MOST_FILES = 60
"""Most scripts, those nearest to the root first."""
WORDS = r"(?:(?:ba)?sh[ \t]+)?((?:\./)?[\w.-]+\.(?:ba)?sh)"
_MAKES = pattern(r"-m[ \t]+venv[ \t]|\b(?:virtualenv|uv[ \t]+venv)[ \t]")
_ENTERS = pattern(r"^(?:source|\.)[ \t]+\S*/bin/activate[\"']?$")
_OF_VENV = pattern(r"[\"']?(?:[\w.${}-]{1,60}/){1,4}bin/(python[\d.]*|pip[\d.]*|[\w.-]{1,60})[\"']?(?=[ \t]|$)")
_PYTHON = pattern(r"(python[\d.]*|pip[\d.]*)(?=[ \t])")
_INSTALLS = pattern(r"(?:python[\d.]*[ \t]+-m[ \t]+)?pip[\d.]*[ \t]+install[ \t]")
_HANDS_ON = pattern(r"[ \t]+[\"']?\$(?:\{?[@*]\}?)[\"']?$")
"""The arguments that the script is given."""
_SETS = pattern(
    r"cd[ \t]+[\"']?\$[^/;&|]{1,80}(?:\|\|[ \t]*exit[ \t]*\d*)?$"
    r"|[A-Za-z_]\w{0,40}=(?:\"[^\"]*\"|'[^']*'|[\"']?\$\(.*\)[\"']?|[^\s;&|]*)$"
    r"|(?:source|\.)[ \t]+[\"']?\S*(?:/bin/activate|/setup\.(?:ba)?sh)[\"']?$"
)
"""A line that changes the state of the script alone: it goes to its own folder, sets a variable, or enters."""
_QUOTED = pattern(r"\"[^\"]*\"|'[^']*'")
_TOLD = pattern(r"\d?>&\d|&?\d?>[ \t]*/dev/null")
_PARTS = pattern(r"[ \t]*(?:&&?|\|\|?|;+|(?<!\S)(?:then|else|\{|\})(?!\S))[ \t]*")
_PREPARES = pattern(
    r"(?:set|echo|printf|exit|if|elif|fi|sleep|clear|uv[ \t]+venv)(?=[ \t]|$)"
    r"|(?:![ \t]+)?(?:\[\[?|command|grep|test|type|which)[ \t]"
    r"|(?:source|\.)[ \t]+\S*(?:/bin/activate|/setup\.(?:ba)?sh)$"
    r"|(?:sudo[ \t]+)?apt(?:-get)?[ \t]|(?:\S{1,40}[ \t]+-m[ \t]+)?(?:venv|virtualenv)[ \t]"
)
"""What such a script does besides, and an image does at another time or not at all."""


def calls(repository: Repository) -> dict[str, TaskCalls]:
    """Return what the scripts of each folder of a tree run that make an environment of their own."""
    return repository.once(_scripts)


def _scripts(repository: Repository) -> dict[str, TaskCalls]:
    found: dict[str, dict[str, File]] = {}
    for file in nearest(repository.suffixed(*SHELL_SCRIPTS))[:MOST_FILES]:
        if file.size <= MAX_SIZE and _MAKES.search(repository.read(file)):
            found.setdefault(file.folder, {})[file.name] = file
    return {folder: TaskCalls(partial(_run, repository, files)) for folder, files in found.items()}


def _run(repository: Repository, files: dict[str, File], call: str) -> str | None:
    file = files.get(call.removeprefix("./"))
    return joined(started(repository.read(file))) if file else None


def started(script: str) -> tuple[str, ...]:
    """Return what a script installs and starts in the environment that it makes, ``()`` where it does more."""
    kept: list[str] = []
    entered = False
    if "/.." in script:  # it goes to another folder than its own
        return ()
    for line in _lines(script):
        entered = entered or bool(_ENTERS.match(line))
        said = line.removeprefix("exec ").lstrip()
        named = _OF_VENV.match(said) or (_PYTHON.match(said) if entered else None)
        if kept and not _INSTALLS.match(kept[-1]):
            return ()  # something follows what it started
        if named and not _MAKES.search(said):
            kept.append(f"{named[1]}{_HANDS_ON.sub('', said[named.end() :])}")
        elif not _prepares(line):
            return ()
    if not kept or _INSTALLS.match(kept[-1]) or any(set(line) & set("$`;&|<>") for line in kept):
        return ()
    # A program that the project installs is read at the beginning of a line alone
    return tuple(kept if _PYTHON.match(kept[-1]) else kept[-1:])


def _prepares(line: str) -> bool:
    """Tell whether each command of a line is one without which the program starts all the same; none writes a file."""
    if _SETS.match(line):
        return True
    bare = _TOLD.sub("", _QUOTED.sub('""', line))
    return not {*bare} & {*"<>"} and all(_PREPARES.match(part) for part in _PARTS.split(bare) if part)


def _lines(script: str) -> Iterator[str]:
    for line in script.replace("\\\n", " ").splitlines():
        if (said := line.strip()) and not said.startswith("#"):
            yield said
