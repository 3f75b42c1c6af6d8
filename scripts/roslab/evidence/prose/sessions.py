"""What the author runs by files of tmuxinator and tmuxp, and by scripts that are called after starting.

https://github.com/tmuxinator/tmuxinator/blob/master/README.md (Usage), https://tmuxp.git-pull.com/configuration/,
read 2026-11-27.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import Any

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN, commands, logical_lines
from roslab.evidence.prose.runners import by_ros, started
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern
from roslab.values.words import joined

MAX_SIZE = 64 * 1024
MAX_FILES = 40
"""Most files that are opened, those nearest to the root first."""
MAX_DEPTH = 2
MAX_NESTED = 6
"""Most folders above a script that starts the whole."""
_PYTHON = pattern(r"python[23]?(?:\.\d+)?")
_STARTS = pattern(r"(?:start|run)(?:[_-][\w-]*)?\.(?:sh|bash)")
_CONTAINER = pattern(r"\b(?:docker|podman|singularity|apptainer)\b")
"""A script that starts containers on the host is no program of the image."""
_WORDS = ("roslaunch", "rosrun", "ros2", "python")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the lines of each file that start something, the files nearest to the root first."""
    for file in nearest(list(_sessions(repository)))[:MAX_FILES]:
        yield from _of_session(repository, file)
    scripts = [f for f in repository.suffixed(*SHELL_SCRIPTS) if _STARTS.fullmatch(f.name) and _near(f)]
    for file in nearest(scripts)[:MAX_FILES]:
        text = repository.read(file)
        if _CONTAINER.search(text):
            continue
        for line, logical in logical_lines(text) if any(word in text for word in _WORDS) else ():
            yield from _started(repository, file, logical, line)


def _sessions(repository: Repository) -> Iterator[File]:
    for file in repository.suffixed(".yml", ".yaml"):
        if file.size <= MAX_SIZE and not places.vendored(file.path) and not places.test(file.path):
            text = repository.read(file)
            if "windows:" in text and ("panes:" in text or "layout:" in text):
                yield file


def _near(file: File) -> bool:
    return file.size <= MAX_SIZE and file.path.count("/") <= MAX_DEPTH and not places.aside(file.path)


def _of_session(repository: Repository, file: File) -> Iterator[Mention]:
    from roslab.evidence.lex.yaml import load  # noqa: PLC0415 - few trees have such files

    text = repository.read(file)
    document = load(text)
    windows = document.get("windows") if isinstance(document, dict) else None
    for typed in _typed(windows) if isinstance(windows, list) else ():
        at = text.find(typed.partition("\n")[0])
        yield from _started(repository, file, typed, text.count("\n", 0, max(0, at)) + 1)


def _typed(value: Any, depth: int = 0) -> Iterator[str]:
    """Yield what is typed into the panes: the texts of windows, but for those that only set something."""
    if depth > MAX_NESTED:  # an anchor of YAML may hold itself
        return
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        for each in value:
            yield from _typed(each, depth + 1)
    elif isinstance(value, dict):
        for name, each in value.items():
            if name not in {"layout", "root", "start_directory", "window_name", "options", "focus"}:
                yield from _typed(each, depth + 1)


def _started(repository: Repository, file: File, text: str, line: int) -> Iterator[Mention]:
    for command in map(started, commands(text, line)):
        words = command.words
        python = bool(_PYTHON.fullmatch(words[0])) and len(words) > 1 and words[1].endswith(".py")
        if any(UNKNOWN in word or "$" in word for word in words) or not (python or by_ros(words[0], words)):
            continue
        found = [_in_tree(repository, word, file) if number else (word, "") for number, word in enumerate(words)]
        yield Mention(
            topic="session",
            value=joined(word for word, _ in found),
            source="script",
            file=file.path,
            line=command.line,
            text=" ".join(words)[:200],
            files=tuple(path for _, path in found if path),
        )


def _in_tree(repository: Repository, word: str, file: File) -> tuple[str, str]:
    """Return a word with its path as it is from the root, and that path where the tree has it.

    What starts the session goes to its folder before; a script may be started from the root, too.
    """
    option, sign, path = word.rpartition(":=") if ":=" in word else word.rpartition("=")
    if path.startswith(("/", "~")) or not ("/" in path or "." in path):
        return word, ""
    for folder in (file.folder, ""):
        here = posixpath.normpath(posixpath.join(folder, path))
        if repository.has(here):
            return f"{option}{sign}{here}", here
    return word, ""
