"""Pages that the page at the root links to, and that alone say what is started."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.readme import MAX_SIZE, of_page, pages, text_of
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

_LINK = pattern(
    r"\]\(\s*<?(?:https?://git(?:hub|lab)\.com/[\w.-]+/[\w.-]+/(?:-/)?(?:blob|tree)/[\w.-]+/)?(?:\./|/)?"
    r"([\w.-][\w./-]*\.(?:md|rst))(?:#[^)\s]*)?>?\s*\)"
)
"""A link of Markdown to a page, by its path or by its whole address; that of a file that the tree lacks is no such."""
_ASIDE = pattern(
    r"contribut|change|licen[sc]e|conduct|security|faq|trouble|news|history|author|issue|docker|develop|tools?\b"
)
MOST = 12
"""Most pages that are read."""


def read(repository: Repository, known: tuple[Mention, ...]) -> tuple[Mention, ...]:
    """Return what the linked pages run, nothing where a page that is read anyway (``known``) runs something.

    What such a page installs is not read: it may be for another machine than the one that the root is about.
    """
    if any(mention.topic == "command" and mention.source == "readme" for mention in known):
        return ()
    said = (mention for file in _pages(repository) for mention in of_page(repository, file).mentions)
    return tuple(mention for mention in said if mention.topic == "command")


def _pages(repository: Repository) -> Iterator[File]:
    read = pages(repository)
    taken = {page.path for page in read}
    files = {file.path: file for file in repository.suffixed(".md", ".rst") if file.size <= MAX_SIZE}
    for page in read:
        if "/" in page.path:
            return
        for match in _LINK.finditer(text_of(repository, page)):
            path = posixpath.normpath(match[1])
            if path in taken or len(taken) - len(read) >= MOST or not (file := files.get(path)):
                continue
            taken.add(path)
            if not (places.vendored(path) or places.test(path) or _ASIDE.search(posixpath.basename(path).lower())):
                yield file
