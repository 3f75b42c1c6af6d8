"""Files that a page fetches with wget or curl, and archives that it unpacks."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from typing import Literal

from roslab.evidence.facts import Mention
from roslab.evidence.lex.shell import UNKNOWN
from roslab.evidence.prose.started_in import ends
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

Topic = Literal["fetched", "unpacked"]
_URL = pattern(rf"https?://[^\s\"'<>{UNKNOWN}]+/[^\s\"'<>{UNKNOWN}]+$")
_FILE = pattern(r"[\w][\w.,=+ -]*\.\w{1,10}$")
_PATH = pattern(r"(?!/|~)[\w./,=+-]+$")
_ARCHIVE = pattern(r"\.(?:zip|tar|tgz|tbz2|tar\.(?:gz|bz2|xz))$")
INTO = {"wget": ("-O", "--output-document"), "curl": ("-o", "--output")}
BELOW = {
    "wget": ("-P", "--directory-prefix"), "curl": ("--output-dir",), "unzip": ("-d",), "tar": ("-C", "--directory"),
}  # fmt: skip
_BUILD_FILES = ("setup.py", "CMakeLists.txt", "Makefile")
PROGRAMS = frozenset(BELOW)


def told(words: tuple[str, ...], folder: str) -> Iterator[tuple[Topic, str]]:
    """Yield ``URL PATH`` for what wget or curl fetches, ``ARCHIVE FOLDER`` for what unzip or tar unpacks.

    ``folder``: where the page is by then. Paths are relative to where it began, ``.`` for that.
    """
    program = words[0].rpartition("/")[2]
    below = option(words, BELOW[program]) or "."
    if program in INTO:
        url = next((word for word in words[1:] if _URL.match(word)), "")
        name = url.partition("?")[0].rpartition("/")[2]
        named = option(words, INTO[program])
        if program == "curl" and not (named or {"-O", "--remote-name"} & set(_letters(words))):
            return
        path = posixpath.join(below, named or (name if _FILE.match(name) else ""))
        if url and not path.endswith(("/", "/-")) and _PATH.match(path):
            yield "fetched", f"{url} {_from(folder, path)}"
        return
    archive = next((word for word in words[1:] if _ARCHIVE.search(word) and _PATH.match(word)), "")
    if archive and _PATH.match(below):
        yield "unpacked", f"{_from(folder, archive)} {_from(folder, below)}"


def placed(mention: Mention, repository: Repository) -> Mention | None:
    """Return what is fetched or unpacked with paths from the repository's root; ``None`` outside, or where it is there.

    The value is the URL, or of what is unpacked the build file that names it. A page
    may begin above the root, and go into the repository by its name.
    """
    first, last = mention.value.split(" ", 1)
    paths = [last] if mention.topic == "fetched" else [first, last]
    found = tuple(_at(path, repository) for path in paths)
    if any(path.startswith("..") for path in found) or (mention.topic == "fetched" and repository.has(found[0])):
        return None
    value = first if mention.topic == "fetched" else _reader(found[0], found[1], repository)
    return replace(mention, value=value, files=found)


def stem_of(archive: str) -> str:
    """Return the name of an archive without its folder and ending: most hold one folder of that name."""
    return _ARCHIVE.sub("", posixpath.basename(archive))


def _reader(archive: str, folder: str, repository: Repository) -> str:
    """Return the build file at the root that names the folder which an archive holds, ``""`` for none.

    The folder that it goes to may begin above the root.
    """
    above = [end for end in ends("" if folder == "." else folder) if end or "/" not in folder]
    below = "|".join(re.escape(posixpath.join(end, stem_of(archive))) for end in above)
    named = re.compile(rf"(?<![\w.-])(?:{below})(?![\w.-])")
    there = (name for name in _BUILD_FILES if repository.has(name))
    return next((name for name in there if named.search(repository.read(name))), "")


def _at(path: str, repository: Repository) -> str:
    """Return a path from the first of its folders on that the root has, the path where it has none of them."""
    folder, name = posixpath.split(path)
    there = (end for end in ends("" if folder == "." else folder) if end.partition("/")[0] in repository.folders - {""})
    return posixpath.normpath(posixpath.join(next(there, folder), name))


def _from(folder: str, path: str) -> str:
    return posixpath.normpath(posixpath.join(folder, path))


def _letters(words: tuple[str, ...]) -> Iterator[str]:
    """Yield the options, those that stand behind one dash (``-LO``) each alone."""
    for word in words[1:]:
        if word.startswith("-") and not word.startswith("--"):
            yield from (f"-{letter}" for letter in word[1:])
        else:
            yield word


def option(words: tuple[str, ...], names: tuple[str, ...]) -> str:
    """Return the value of an option, ``""`` without it; a short one may end a group (``-qO file``)."""
    for index, word in enumerate(words[1:], 1):
        name, equals, value = word.partition("=")
        short = word.startswith("-") and not word.startswith("--") and f"-{word[-1]}" in names
        if equals and name in names:
            return value
        if (word in names or short) and index + 1 < len(words):
            return words[index + 1]
    return ""
