"""What a container of an author's Dockerfile starts, by its command or by the script that this names.

Where the source is mounted into the container, that image is not built, and this still tells which program is meant.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import AuthorDockerfile, Mention
from roslab.evidence.lex.shell import UNKNOWN, Command, commands, logical_lines
from roslab.evidence.prose.own_files import only
from roslab.evidence.prose.runners import by_ros, started
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern
from roslab.values.words import joined, line_of

MAX_SIZE = 64 * 1024
_SCRIPT = pattern(r"[\w.+/-]+\.(?:sh|bash)")
_PYTHON = pattern(r"python[23]?(?:\.\d+)?")
_SHELLS = frozenset({"bash", "sh", "source", "."})
_HANDS_OVER = pattern(r"(?m)^[ \t]*exec[ \t][^\n#]*\$[@*{1]")
"""A line of a script that starts what it is given: what stands before it only prepares that."""


def read(repository: Repository, dockerfiles: Iterable[AuthorDockerfile]) -> Iterator[Mention]:
    """Yield the program of each Dockerfile of the project whose containers start a single one; its text is the file."""
    for authored in dockerfiles:
        if authored.purpose != "project":
            continue
        given = authored.service.command if authored.service else ()
        texts = [line_of(words) for words in (authored.entrypoint, given or authored.command) if words]
        at = Mention(
            topic="contained",
            value="",
            source="dockerfile",
            file=authored.file,
            line=authored.command_line or authored.line,
            text=authored.file,
        )
        found = [each for text in texts for each in _programs(repository, text, at, authored)]
        if len({each.value for each in found}) == 1:
            yield found[0]


def _programs(repository: Repository, text: str, at: Mention, authored: AuthorDockerfile) -> Iterator[Mention]:
    for command in commands(text, at.line):
        script = _script(repository, command, authored)
        if script is None:
            yield from _program(repository, command, at, authored)
            continue
        if _HANDS_OVER.search(written := repository.read(script)):
            continue
        for line, logical in logical_lines(written):
            for inner in commands(logical, line):
                yield from _program(repository, inner, _at(at, script.path, inner.line), authored)


def _script(repository: Repository, command: Command, authored: AuthorDockerfile) -> File | None:
    """Return the script of the tree that a command starts: the only one of its name, else the one by the Dockerfile."""
    words = command.words[1:] if command.words[0] in _SHELLS else command.words
    if not words or not _SCRIPT.fullmatch(words[0]):
        return None
    named = [file for file in repository.named(posixpath.basename(words[0])) if file.size <= MAX_SIZE]
    near = [file for file in named if file.folder == authored.file.rpartition("/")[0]]
    return next(iter(near or named), None) if len(near or named) == 1 else None


def _program(repository: Repository, command: Command, at: Mention, authored: AuthorDockerfile) -> Iterator[Mention]:
    command = started(command)
    words = command.words
    python = bool(_PYTHON.fullmatch(words[0])) and len(words) > 1 and words[1].endswith(".py")
    if any(UNKNOWN in word or "$" in word for word in words) or not (python or by_ros(words[0], words)):
        return
    named = [index and ("/" in word or (index == 1 and "." in word)) for index, word in enumerate(words)]
    found = [_in_tree(repository, word, authored) if path else "" for word, path in zip(words, named, strict=True)]
    value = joined(path or word for path, word in zip(found, words, strict=True))
    yield _at(at, at.file, at.line, value=value, files=tuple(filter(None, found)))


def _at(at: Mention, file: str, line: int, *, value: str = "", files: tuple[str, ...] = ()) -> Mention:
    return Mention(topic="contained", value=value, source="dockerfile", file=file, line=line, text=at.text, files=files)


def _in_tree(repository: Repository, word: str, authored: AuthorDockerfile) -> str:
    """Return the file of the tree that a path of the container means, by as much of its end as there is one file of."""
    parts = [part for part in posixpath.normpath(word).split("/") if part not in {"", ".."}]
    if "." not in word or not parts:
        return ""
    near = posixpath.normpath(posixpath.join(authored.context or "", *parts))
    if repository.has(near):
        return near
    tails = ("/".join(parts[start:]) for start in range(max(1, len(parts) - 1)))
    return next((path for tail in tails if (path := tail if repository.has(tail) else only(tail, repository))), "")
