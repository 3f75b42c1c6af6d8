"""The release of libtorch that a page names, or that a script, CI or a Dockerfile downloads."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_FILES = 100
"""Most files that are opened, those nearest to the root first."""
_SITE = "download.pytorch.org/libtorch/"
_ADDRESS = (
    r"download\.pytorch\.org/libtorch/[^\s\"')]{0,80}?/"
    r"libtorch-(?!win|macos)[a-z0-9-]{1,60}?-(\d\.\d{1,2}\.\d)(?:%2b|\+|\.zip)"
)
_NAMED = pattern(rf"{_ADDRESS}|\blibtorch\b[^\n]{{0,60}}?(?<![\d.])(\d\.\d{{1,2}}(?:\.\d)?)(?!\.?\d)")
_DOWNLOADED = pattern(_ADDRESS)
_SCRIPTS = (".sh", ".bash", ".yml", ".yaml", ".dockerfile")


def read(file: str, text: str) -> Iterator[Mention]:
    """Yield each release that stands behind the name, in a sentence or in the address of an archive."""
    lowered = text.lower()
    for match in _NAMED.finditer(lowered) if "libtorch" in lowered else ():
        line = text.count("\n", 0, match.start()) + 1
        value = match[1] or match[2]
        yield Mention(topic="libtorch", value=value, source="readme", file=file, line=line, text=match[0])


def in_scripts(repository: Repository) -> Iterator[Mention]:
    """Yield the release of each archive for Linux that a script, CI or a Dockerfile downloads."""
    files = [*repository.suffixed(*_SCRIPTS), *repository.named("Dockerfile")]
    files = [file for file in files if file.size <= MAX_SIZE and not places.vendored(file.path)]
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for match in _DOWNLOADED.finditer(text.lower()) if _SITE in text else ():
            line = text.count("\n", 0, match.start()) + 1
            yield Mention(topic="libtorch", value=match[1], source="script", file=file.path, line=line, text=match[0])
