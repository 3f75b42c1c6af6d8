"""Programs that the shell scripts call which pages run: ``tmuxinator``, ``jq``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.lex.lines import blank
from roslab.evidence.prose import first_lines
from roslab.knowledge.compiled import programs
from roslab.knowledge.unpackaged_programs import unpackaged_programs
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

IN_SCRIPT = "in_script"
"""The role of what such a script needs."""
MAX_SIZE = 64 * 1024
_SCRIPT = (".sh", ".bash", ".zsh")
_CALLED = pattern(
    r"(?:^|[;&|(`{]|\b(?:then|do|else|if|elif|while|until|sudo|exec|time|nohup|command)[ \t]|![ \t])"
    r"[ \t]*(?!(?:then|do|else|if|elif|while|until|sudo|exec|time|nohup|command)\b)([A-Za-z][\w.+-]*)(?=[ \t;&|]|$)",
    re.MULTILINE,
)
"""A word where a command begins, also in ``$(…)``."""
_LAST_OF_PIPE = pattern(r"(?:\$\(|`)[^()`\n]{0,200}\|[ \t]*([A-Za-z][\w.+-]*)(?=[)`])")
"""The word that ends ``$(… | bc)``; quotes and the patterns of a ``case`` are taken out before."""
_CASE = pattern(r"\bcase[ \t][^\n]{0,200}?[ \t]in\b(?:(?!\besac\b)[^`]){0,4000}\besac\b")
_PATTERNS = pattern(r"(?:(?<=\bin)|(?<=;;)|(?<=;&))\s{0,200}\(?[\w.*?|+/ \t\[\]-]{1,300}\)")
_QUOTED = pattern(r"'[^'\n]{0,1000}'|\"[^\"$`\\\n]{0,1000}\"")
"""What is in quotes and starts no program of its own."""
_FUNCTION = pattern(r"(?<![\w.+-])([A-Za-z][\w.+-]*)[ \t]*\(\)")
_NOT_RUN = pattern(
    r"(?m)(?:^|(?<=\s))#.*$|(?<![\w./-])(?:echo|printf)\s(?:\"(?:[^\"\\\n]|\\[^\n]){0,500}\"|'[^'\n]{0,500}'|[^;&|\"'\n]){0,500}"
)
"""A comment, and what a line prints."""
_GOES_ON = pattern(r"\\\r?\n")
"""The end of a line that the next one goes on: what that begins with is an argument, as of ``apt install``."""
_EVERYWHERE = frozenset({"file", "ip", "ping", "ps", "python", "python2", "python3", "pip", "pip3", "sed"})
"""Every image of this program's has them, or what has them depends on the Python that is taken."""
PYTHON = "python-is-python3"
"""What has ``python`` where ROS runs on Python 3: https://packages.ubuntu.com/focal/python-is-python3, 2026-11-27"""
_ENTERS = pattern(r"\b(?:activate|(?:conda|mamba|poetry|pipenv|uv|pixi)\s+run)\b|\balias\s+python=")
"""A script with it has a ``python`` of its own."""


def read(repository: Repository, said: Iterable[Mention]) -> tuple[Dependency, ...]:
    """Return the packages of apt with these programs, each once for a script, and of those in a first line."""
    return (
        tuple(
            Dependency(namespace="apt", name=programs()[name], strength="used", file=file, line=line, role=IN_SCRIPT)
            for name, file, line in _calls(repository, said)
            if name in programs()
        )
        + tuple(
            Dependency(namespace="apt", name=PYTHON, strength="used", file=file, line=line, role=IN_SCRIPT)
            for file, script in _scripts(repository, said)
            for name, line in calls_of(script)
            if name == "python" and not _ENTERS.search(script)
        )
        + tuple(first_lines.read(repository, said))
    )


def unpackaged(repository: Repository, said: Iterable[Mention]) -> tuple[Mention, ...]:
    """Return where they call what no package brings."""
    return tuple(
        Mention(topic="unpackaged", value=name, source="script", file=file, line=line, text=name)
        for name, file, line in _calls(repository, said)
        if name in unpackaged_programs()
    )


def _calls(repository: Repository, said: Iterable[Mention]) -> Iterator[tuple[str, str, int]]:
    """Yield each program with its script and the first line that calls it."""
    known = (programs().keys() | unpackaged_programs().keys()) - _EVERYWHERE
    for file, script in _scripts(repository, said):
        yield from ((name, file, line) for name, line in calls_of(script) if name in known)


def _scripts(repository: Repository, said: Iterable[Mention]) -> Iterator[tuple[str, str]]:
    """Yield each script of the tree that a page runs, with its text."""
    commands = (mention for mention in said if mention.topic == "command" and mention.source == "readme")
    files = dict.fromkeys(file for mention in commands for file in mention.files if file.endswith(_SCRIPT))
    for file in files:
        if repository.has(file) and not places.vendored(file):
            yield file, repository.read(file, limit=MAX_SIZE)


def calls_of(script: str) -> Iterator[tuple[str, int]]:
    """Yield each word where a command of a script begins, with its first line; functions of the script are none."""
    lines = _NOT_RUN.sub("", script)
    text = _GOES_ON.sub(_blank_ends, lines)
    functions = set(_FUNCTION.findall(text))
    seen: set[str] = set()
    piped = _QUOTED.sub(_blank, _CASE.sub(_without_patterns, text)) if "|" in text else ""
    found = (*_CALLED.finditer(text), *_LAST_OF_PIPE.finditer(piped))
    for match in sorted(found, key=lambda each: each.start(1)):
        if (name := match[1]) not in functions | seen:
            seen.add(name)
            yield name, lines.count("\n", 0, match.start(1)) + 1


def _without_patterns(case: re.Match[str]) -> str:
    """Return a ``case`` with blanks in place of what it compares with, as long as before."""
    return _PATTERNS.sub(_blank, case[0])


def _blank(match: re.Match[str]) -> str:
    return blank(match[0])


def _blank_ends(match: re.Match[str]) -> str:
    return " " * len(match[0])
