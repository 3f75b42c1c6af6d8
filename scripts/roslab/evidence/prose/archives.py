"""Releases that are fetched as an archive: each is the tag of a repository."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from roslab.evidence.dependency import GitSource
from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.knowledge.source_archives import source_archive
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_ARCHIVE = pattern(r"(https://github\.com/[\w-]+/([\w.-]+))/archive/(?:refs/tags/)?([\w.+-]+?)\.(?:zip|tar\.gz|tgz)$")
_RELEASE = pattern(
    r"(https://github\.com/[\w-]+/([\w.-]+))/releases/download/(v?([\d.]+))/"
    r"([A-Za-z]\w*|\2)-v?\4\.(?:zip|tgz|tar\.(?:gz|bz2|xz))$"
)
"""A file of a release whose name is that of the project and the release only: its source, and no program. One with a
hyphen is the repository's: others say for which system it is."""
_INTO = ("-C", "--directory")
_STRIPS = "--strip"
"""``--strip-components``, which tar takes by its beginning, too."""


def is_release(url: str) -> bool:
    """Tell whether an address is that of a repository's archive."""
    return bool(_ARCHIVE.match(url) or _RELEASE.match(url) or source_archive(url))


def archives(command: Command, file: str, sources: list[GitSource], cloned: int | None) -> list[GitSource]:
    """Return the sources with those whose archives ``wget`` or ``curl`` fetches, each by the name of its folder.

    ``tar`` with ``-C`` puts the last one into another folder where it drops the archive's own: ``/opt`` is else the
    folder of many. That is none if it is ``cloned``, the last one of git.
    """
    if command.words[0].rpartition("/")[2] == "tar":
        stripped = any(word.startswith(_STRIPS) for word in command.words)
        folder = next((into for word, into in pairwise(command.words) if stripped and word in _INTO), "")
        there = folder.rstrip("/").rpartition("/")[2].strip(".")
        last = sources[-1:] if there and UNKNOWN not in there and len(sources) - 1 != cloned else []
        return [*sources[: len(sources) - len(last)], *(replace(each, into=there) for each in last if not each.into)]
    return [*sources, *_fetched(command, file)]


def _fetched(command: Command, file: str) -> Iterator[GitSource]:
    for word in command.words:
        archive, release = _ARCHIVE.match(word), _RELEASE.match(word)
        found = archive.group(1, 2, 3) if archive else release.group(1, 5, 3) if release else source_archive(word)
        if found:
            url, name, ref = found
            yield GitSource(
                name=name,
                url=url,
                ref=ref,
                strength="prose",
                file=file,
                line=command.line,
                kind="clone",
            )
