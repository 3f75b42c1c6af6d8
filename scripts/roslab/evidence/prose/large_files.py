"""Pages that have their reader get files from Git LFS: git needs a program of its own for them."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.dependency import Dependency
from roslab.evidence.prose.headings import lines_of
from roslab.evidence.prose.merged import Prose
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.roles import GIT_LFS
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_CALLED = pattern(r"^\s{0,20}(?:[$#>]\s{0,4})?git[ -]lfs\s+(?:install|pull|fetch|clone)\b")
"""https://github.com/git-lfs/git-lfs/blob/main/docs/man/git-lfs.adoc, 2026-11-26"""


def read(repository: Repository) -> Prose:
    """Return the package of that program, at the first command of a page at the root that calls it."""
    files = (file for file in pages(repository) if "/" not in file.path)
    return Prose(tuple(asked for file in files for asked in _called(text_of(repository, file), file.path)))


def _called(text: str, file: str) -> Iterator[Dependency]:
    if "lfs" not in text:
        return
    for line in lines_of(text):
        indented = line.text.startswith("    ")
        if (line.fenced or indented) and not line.elsewhere and _CALLED.match(line.text[:400]):
            yield Dependency(namespace="apt", name=GIT_LFS, strength="prose", file=file, line=line.number, role="named")
            return
