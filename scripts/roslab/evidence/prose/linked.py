"""Pages that the page at the root, or the documentation, links to, and that alone say what is started."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose import search_paths
from roslab.evidence.prose.pages import LINK, MAX_SIZE, pages, path_of, text_of
from roslab.evidence.prose.readme import of_page
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

_INDEX = ("index", "readme")
_ASIDE = pattern(
    r"contribut|change|licen[sc]e|conduct|security|faq|trouble|news|history|author|issue|docker|develop|tools?\b"
)
MOST = 12
"""Most pages that are read."""
DEEPEST = 3
"""Of a page that sets where a simulator looks: it starts that itself."""
WEBOTS = "webots "


_STARTS = ("roslaunch ", "ros2 launch ")
_WIKI = pattern(r"(?:[\w-]+\.)?wiki/", re.IGNORECASE)


def read(repository: Repository, known: tuple[Mention, ...], *, ros: bool) -> tuple[Mention, ...]:
    """Return what the linked pages run, nothing where a page that is read anyway (``known``) runs something.

    What such a page installs is not read: it may be for another machine than the one that the root is about. Where no
    page launches anything of a repository for ROS, also what the pages of a wiki in the tree launch.
    """
    said = _linked(repository, known)
    if not ros or any(_launches(mention) for mention in (*known, *said)):
        return said
    return (
        *said,
        *(m for file in _wiki(repository) for m in of_page(repository, file).mentions if _launches(m)),
    )


def _launches(mention: Mention) -> bool:
    return mention.topic == "command" and mention.source == "readme" and mention.value.startswith(_STARTS)


def _wiki(repository: Repository) -> list[File]:
    """Return the pages of a copy of the wiki that may launch something; they are linked to each other, if at all."""
    taken = {page.path for page in pages(repository)}
    found = (file for file in repository.suffixed(".md", ".rst") if file.size <= MAX_SIZE and file.path not in taken)
    own = [file for file in found if _WIKI.match(file.path) and not _ASIDE.search(file.name.lower())]
    return [file for file in nearest(own)[:MOST] if any(start in repository.read(file) for start in _STARTS)]


def _linked(repository: Repository, known: tuple[Mention, ...]) -> tuple[Mention, ...]:
    if any(mention.topic == "command" and mention.source == "readme" for mention in known):
        return ()
    said: list[Mention] = []
    for file in _pages(repository):
        told = of_page(repository, file).mentions
        said += (m for m in told if m.topic == "command" or (m.topic == "step" and m.value.startswith(WEBOTS)))
        said += search_paths.read(repository, file, text_of(repository, file), deepest=DEEPEST)
    return tuple(said)


def _pages(repository: Repository) -> Iterator[File]:
    """Yield the pages behind the links of the root's pages, then those behind the documentation's, each once."""
    read = pages(repository)
    taken = {page.path for page in read}
    files = {file.path: file for file in repository.suffixed(".md", ".rst") if file.size <= MAX_SIZE}
    waiting = [page for page in read if "/" not in page.path or places.documentation(page.path)]
    found = 0
    while waiting:
        page = waiting.pop(0)
        for path in _links(page, repository, files):
            if path in taken or found >= MOST:
                continue
            taken.add(path)
            if not (places.vendored(path) or places.test(path) or _ASIDE.search(posixpath.basename(path).lower())):
                found += 1
                waiting += [files[path]] if places.documentation(path) else []
                yield files[path]


def _links(page: File, repository: Repository, files: Mapping[str, File]) -> Iterator[str]:
    """Yield the paths of the pages that a page links to; of a folder its index first, then the pages right in it."""
    for match in LINK.finditer(text_of(repository, page)):
        path = path_of(match, page)
        if path in files:
            yield path
        elif path in repository.folders and places.documentation(f"{path}/"):
            inside = [each for each in files if posixpath.dirname(each) == path]
            yield from sorted(inside, key=lambda each: not posixpath.basename(each).lower().startswith(_INDEX))
