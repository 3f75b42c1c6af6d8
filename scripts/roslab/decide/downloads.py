"""Files that the default command or the build names and the tree lacks: what a page fetches, the image has."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.candidate import Candidate
from roslab.decide.decision import Choice, Download, Reason
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.downloads import stem_of
from roslab.values.pattern import pattern
from roslab.values.words import line_of

_ASSIGNS = pattern(r":?=")

WEIGHT = 300
"""Files do not compete, so it only orders the report."""
MOST = 6


def decide_downloads(
    evidence: Evidence,
    config: Config,
    command: tuple[str, ...] | str,
    folder_name: str,
    page: Candidate | None = None,
) -> Choice[tuple[Download, ...]]:
    """Return what pages near the root fetch of what the command or the build names.

    An archive that a page unpacks is meant where the command names a path in it, or in the folder that it goes to, and
    so is what the last script of the tree fetches which the ``page`` runs before the command in the same section: its
    configuration may name it. ``folder_name`` is the repository's.
    """
    if config.compatible:
        return Choice(answer=())
    named = set(_named(line_of(command)))
    fetched = [m for m in evidence.mentions if m.topic == "fetched" and _near(m)]
    unpacked = [m for m in evidence.mentions if m.topic == "unpacked" and _near(m)]
    before = _before(fetched, page)
    found: dict[str, tuple[Download, Reason]] = {}
    for mention in fetched:
        path = _inside(mention.files[0], folder_name)
        archive = next((m for m in unpacked if m.file == mention.file and m.files[0] == mention.files[0]), None)
        folder = _inside(archive.files[1], folder_name) if archive else None
        if _outside(path) or (folder is not None and _outside(folder)):
            continue
        meant = path in named if folder is None else any(_in_archive(each, path, folder) for each in named)
        reader = "the command" if meant else archive.value if archive else ""
        if reader or (mention.inside and mention.line == before):
            why = f"{reader} names it, and the page fetches it" if reader else "the page fetches it before the command"
            reason = because("downloads", mention.value, why, mention, weight=WEIGHT)
            found.setdefault(path, (Download(url=mention.value, path=path, unpack=folder), reason))
    chosen = list(found.values())[:MOST]
    return Choice(answer=tuple(each for each, _ in chosen), reasons=tuple(reason for _, reason in chosen))


def _before(fetched: list[Mention], page: Candidate | None) -> int:
    """Return the line of the last script that fetches in the section of a command, before it; 0 for none."""
    if page is None or not page.heading:
        return 0
    same = (m for m in fetched if m.inside and (m.file, m.heading) == (page.file, page.heading))
    return max((m.line for m in same if m.line < page.line), default=0)


def _near(mention: Mention) -> bool:
    aside = places.vendored(mention.file) or places.test(mention.file)
    return mention.source == "readme" and mention.file.count("/") <= 1 and not aside


def _named(command: str) -> Iterator[str]:
    """Yield the paths in the words of a command, also behind ``=``, from the root of the repository."""
    words = shlex.split(command)
    folder = words[1] if words[:1] == ["cd"] and len(words) > 1 else ""
    for word in words:
        path = _ASSIGNS.split(word, maxsplit=1)[-1]
        if path and not path.startswith(("/", "~", "-")):
            yield posixpath.normpath(posixpath.join(folder, path))


def _inside(path: str, folder_name: str) -> str:
    """Return a path without the repository's own folder, above which a page may begin."""
    first, _, rest = path.partition("/")
    return (rest or ".") if first.lower() == folder_name.lower() else path


def _outside(path: str) -> bool:
    return path.startswith(("..", "/", "~"))


def _in_archive(named: str, archive: str, folder: str) -> bool:
    """Tell whether a path is what an archive holds: below the folder it goes to, and below its own name at the root."""
    below = [posixpath.normpath(posixpath.join(folder, stem_of(archive))), *([] if folder == "." else [folder])]
    return any(named == each or named.startswith(f"{each}/") for each in below)
