"""Releases that are fetched as an archive: each is the tag of a repository."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.dependency import GitSource
from roslab.evidence.lex.shell import Command
from roslab.values.pattern import pattern

_ARCHIVE = pattern(r"(https://github\.com/[\w-]+/([\w.-]+))/archive/(?:refs/tags/)?([\w.+-]+?)\.(?:zip|tar\.gz|tgz)$")


def is_release(url: str) -> bool:
    """Tell whether an address is that of a repository's archive."""
    return bool(_ARCHIVE.match(url))


def archives(command: Command, file: str) -> Iterator[GitSource]:
    """Yield the repositories and tags whose archives ``wget`` or ``curl`` fetches."""
    for word in command.words:
        if match := _ARCHIVE.match(word):
            yield GitSource(
                name=match[2],
                url=match[1],
                ref=match[3],
                strength="prose",
                file=file,
                line=command.line,
                kind="clone",
            )
