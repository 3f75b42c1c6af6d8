"""Options by which CMake is handed the folder of an archive that a text unpacks: ``-DSDK_ROOT=~/sdk/acme-3.2.7``."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.constants import may_be_set
from roslab.evidence.prose.installs import MentionSource
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MAX_FILES = 60
"""Most CMake files that are searched, those nearest to the root first."""
MAX_SIZE = 64 * 1024
MAX_NAMES = 20
"""Most options for which they are searched."""
MAX_FOUND = 100
"""Most options with a place."""
_HANDED = pattern(
    r"-D[ \t]?(?!CMAKE_)([A-Za-z]\w{2,60})(?::[A-Z]+)?=[\"']?((?:~|/|\$\{?HOME\}?)[\w./+${}-]*/[\w.+-]+)/?"
)
_HOME = pattern(r"^(?:~|\$\{?HOME\}?|/root|/home/[\w.-]+)(?=/)")


@dataclass(frozen=True, kw_only=True, slots=True)
class Handed:
    """An option with the folder that a text gives it: ``~/sdk/acme-3.2.7`` where that is in the reader's home."""

    name: str
    folder: str
    file: str
    line: int
    reader: str
    """The file of CMake that reads it."""


def handed(repository: Repository, texts: Iterable[tuple[File, MentionSource, str]]) -> tuple[Handed, ...]:
    """Return the options with a place that pages, scripts, Dockerfiles and CI hand CMake, and that CMake here reads."""
    found: dict[tuple[str, str], Handed] = {}
    readers: dict[str, str] = {}
    for file, _, text in texts:
        for match in _HANDED.finditer(text) if "-D" in text else ():
            name, folder = match[1], _HOME.sub("~", match[2])
            if "$" in folder or (name, folder) in found or (name not in readers and len(readers) >= MAX_NAMES):
                continue
            if name not in readers:
                readers[name] = _reader(name, repository)
            if (reader := readers[name]) and len(found) < MAX_FOUND:
                line = text.count("\n", 0, match.start()) + 1
                found[name, folder] = Handed(name=name, folder=folder, file=file.path, line=line, reader=reader)
    return tuple(found.values())


def mentions(said: Iterable[Handed], name: str, folder: str, source: MentionSource) -> Iterator[Mention]:
    """Yield ``NAME=~/FOLDER`` once for each option that is handed the folder ``name`` which lies in a ``folder``."""
    told: set[str] = set()
    for each in said:
        if posixpath.basename(each.folder) == name and each.name not in told:
            told.add(each.name)
            value = f"{each.name}=~/{posixpath.normpath(posixpath.join(folder, name))}"
            yield Mention(
                topic="handed_place",
                value=value,
                source=source,
                file=each.file,
                line=each.line,
                text=f"-D{each.name}={each.folder}",
                inside=each.reader,
            )


def _reader(name: str, repository: Repository) -> str:
    """Return the first CMake file of the tree that reads a variable and in which nothing sets it, ``""`` for none."""
    reads = re.compile(rf"\$\{{{name}\}}|\bDEFINED[ \t]+{name}\b")
    files = [*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake")]
    for file in nearest(f for f in files if f.size <= MAX_SIZE and not places.aside(f.path))[:MAX_FILES]:
        text = repository.read(file)
        if name in text and reads.search(text) and not may_be_set(text, name, in_cache=False):
            return file.path
    return ""
