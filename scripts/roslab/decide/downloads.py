"""Files that the default command or the build names and the tree lacks: what a page fetches, the image has."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Iterable, Iterator

from roslab.config.model import Config
from roslab.decide.candidate import Candidate
from roslab.decide.decision import Choice, Download, Reason
from roslab.decide.reasons import because
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.downloads import stem_of
from roslab.evidence.prose.single_headers import placed
from roslab.evidence.x86_only import X86Only
from roslab.values.native_part import NativePart
from roslab.values.pattern import pattern
from roslab.values.words import line_of

_ASSIGNS = pattern(r":?=")
_LETTERS = pattern(r"[A-Za-z][A-Za-z_-]*")
_X86 = pattern(r"(?<![a-z0-9])(?:x86[_-]64|amd64|x64|linux64)(?![a-z0-9])")
_BUILD = ("CMakeLists.txt", ".cmake", "Makefile", ".mk", "setup.py")

_READ = frozenset({"readme", "script", "dockerfile"})

WEIGHT = 300
"""Files do not compete, so it only orders the report."""
MOST = 6


def decide_downloads(
    evidence: Evidence,
    config: Config,
    command: tuple[str, ...] | str,
    folder_name: str,
    *,
    page: Candidate | None = None,
    parts: Iterable[NativePart] = (),
) -> Choice[tuple[Download, ...]]:
    """Return what pages near the root fetch of what the command or the build names.

    An archive that a page unpacks is meant where the command names a path in it, or in the folder that it goes to, and
    so is what the last script of the tree fetches which the ``page`` runs before the command in the same section: its
    configuration may name it. An archive for the user's home comes where the build or the code names its folder there,
    but for those of the ``parts`` of pip's packages. So does a header that is put where every compiler looks.
    ``folder_name`` is the repository's.
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
        if reader and not meant and _renamed(mention.value, path):
            reader = ""
        if reader or (mention.inside and mention.line == before):
            why = f"{reader} names it, and the page fetches it" if reader else "the page fetches it before the command"
            reason = because("downloads", mention.value, why, mention, weight=WEIGHT)
            found.setdefault(path, (Download(url=mention.value, path=path, unpack=folder), reason))
    chosen = [*_headers(evidence), *_for_home(evidence, parts), *found.values()][:MOST]
    return Choice(answer=tuple(each for each, _ in chosen), reasons=tuple(reason for _, reason in chosen))


def names_at_home(evidence: Evidence) -> Iterator[str]:
    """Yield the names of the libraries that archives for the home hold: ``mujoco`` of ``mujoco-3.2.7``."""
    for mention in evidence.mentions:
        if mention.topic != "home_archive":
            continue
        from roslab.evidence.prose.home_archives import name_of  # noqa: PLC0415 - few trees have one

        if name := _LETTERS.match(name_of(mention.value)):
            yield name[0].rstrip("-_.")


def for_x86_alone(evidence: Evidence) -> X86Only | None:
    """Return the first archive for the home with programs of x86-64, if a build file names it."""
    for mention in evidence.mentions:
        if mention.topic == "home_archive" and _X86.search(mention.value) and mention.inside.endswith(_BUILD):
            return X86Only(mention.value, "binary", mention.file, mention.line)
    return None


def _for_home(evidence: Evidence, parts: Iterable[NativePart]) -> Iterator[tuple[Download, Reason]]:
    there = {name for part in parts for name in part.files}
    for mention in evidence.mentions:
        name = mention.value.partition("?")[0].rpartition("/")[2]
        if mention.topic == "home_archive" and name not in there:
            folder, strip = mention.files
            path = posixpath.normpath(posixpath.join(folder, name))
            download = Download(url=mention.value, path=path, unpack=folder, home=True, strip=int(strip))
            why = f"{mention.inside} looks for it in the home, where it is unpacked"
            yield download, because("downloads", mention.value, why, mention, weight=WEIGHT)


def _headers(evidence: Evidence) -> Iterator[tuple[Download, Reason]]:
    """Yield the libraries of one header, each path once."""
    said = (m for m in evidence.mentions if m.topic == "single_header" and m.source in _READ and not _aside(m))
    found: dict[str, tuple[Mention, str]] = {}
    for mention, url, path in placed(tuple(said)):
        found.setdefault(path, (mention, url))
    for path, (mention, url) in found.items():
        download = Download(url=url, path=path.removeprefix("/"), system=True)
        yield download, because("downloads", url, f"the page puts it to {path}", mention, weight=WEIGHT)


def _before(fetched: list[Mention], page: Candidate | None) -> int:
    """Return the line of the last script that fetches in the section of a command, before it; 0 for none."""
    if page is None or not page.heading:
        return 0
    same = (m for m in fetched if m.inside and (m.file, m.heading) == (page.file, page.heading))
    return max((m.line for m in same if m.line < page.line), default=0)


def _renamed(url: str, path: str) -> bool:
    """Tell whether a repository's archive has another name than its folder, by which a build file would name it."""
    from roslab.evidence.prose.archives import is_release  # noqa: PLC0415 - few pages unpack what a build file names

    return stem_of(url) != stem_of(path) and is_release(url)


def _near(mention: Mention) -> bool:
    return mention.source == "readme" and not _aside(mention)


def _aside(mention: Mention) -> bool:
    return places.vendored(mention.file) or places.test(mention.file) or mention.file.count("/") > 1


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
