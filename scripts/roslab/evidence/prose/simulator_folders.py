"""Folders of the tree in which its scripts have a simulator look for models, worlds and plugins."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.search_paths import joined
from roslab.knowledge.search_paths import search_paths
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

MOST = 40
"""Most scripts that are read, those nearest to the root first."""
MAX_SIZE = 64 * 1024
_SUFFIXES = (".sh", ".bash", ".zsh")
_SET = pattern(r"(?:export[ \t]+)?([A-Z][A-Z0-9_]{7,40})=([^\n;#]{1,400})")
_ASSIGNED = pattern(r"(?:export[ \t]+|readonly[ \t]+|local[ \t]+)?([A-Za-z_]\w{0,40})=([^\n;#]{1,400})")
_OF_ITSELF = pattern(r"BASH_SOURCE|\bdirname\b|\$\{?0\b")
_UP = pattern(r"(?<=/)\.\.(?=[/\"' )`]|$)")
_PACKAGE = pattern(r"(?:rospack find|ros2 pkg prefix --share)\s+([\w-]{1,60})\s*")
_VARIABLE = pattern(r"\$\{?(\w{1,40})\}?(?=/|$)")
_WORKING = frozenset({".", "$PWD", "${PWD}", "$(pwd)", "`pwd`"})
"""Where a script is started."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each variable once with all folders of the tree that scripts put into it under no condition.

    The folder of the script itself, that of a package, and one below the repository's own name are known; where the
    script is started from, ``$(pwd)``, is the root or the script's folder.
    """
    found: dict[str, dict[str, tuple[str, int]]] = {}
    scripts = (file for file in repository.suffixed(*_SUFFIXES) if file.size <= MAX_SIZE)
    for file in nearest(file for file in scripts if not (places.vendored(file.path) or places.aside(file.path)))[:MOST]:
        text = repository.read(file)
        if any(name in text for name in search_paths()):
            for name, folder, line in _folders(text, file, repository):
                found.setdefault(name, {}).setdefault(folder, (file.path, line))
    for name, folders in found.items():
        value = f"{name}={joined(folders)}"
        path, line = next(iter(folders.values()))
        yield Mention(topic="variable", value=value, source="script", file=path, line=line, text=value[:80])


def _folders(text: str, file: File, repository: Repository) -> Iterator[tuple[str, str, int]]:
    """Yield variable, folder and line of what a script sets at the beginnings of its lines."""
    own: dict[str, str] = {}
    for number, line in enumerate(text.split("\n"), 1):
        if (match := _SET.match(line)) and match[1] in search_paths():
            for part in match[2].strip().strip("\"'").split(":"):
                if folder := _folder(part.strip("\"' "), own, file, repository):
                    yield match[1], folder, number
        elif (match := _ASSIGNED.match(line)) and _OF_ITSELF.search(match[2]):
            own[match[1]] = _joined(file.folder, "../" * len(_UP.findall(match[2])))


def _folder(written: str, own: Mapping[str, str], file: File, repository: Repository) -> str:
    """Return the folder of the tree that a part of a path means, ``.`` for the root, ``""`` for none."""
    begin, rest = _begin(written)
    named = _PACKAGE.fullmatch(begin[2:-1]) if begin.startswith("$(") else None
    variable = _VARIABLE.fullmatch(begin)
    if begin in _WORKING:
        bases = [".", file.folder]
    elif named:
        folders = [each.folder for each in repository.named("package.xml")]
        bases = [each for each in folders if posixpath.basename(each or repository.name) == named[1]]
    elif begin.startswith("$(") and _OF_ITSELF.search(begin):
        bases = [_joined(file.folder, "../" * len(_UP.findall(begin)))]
    elif variable and variable[1] in own:
        bases = [own[variable[1]]]
    else:
        parts = written.split("/")
        at = next((index for index, part in enumerate(parts) if bare_name(part) == bare_name(repository.name)), None)
        bases, rest = ([], "") if at is None else (["."], "/".join(parts[at + 1 :]))
    paths = (_joined(base, rest) for base in bases)
    return next((path for path in paths if path == "." or path in repository.folders), "")


def _begin(written: str) -> tuple[str, str]:
    """Return the first part of a path, a whole ``$(…)``, and what follows it."""
    depth = 0
    for index, letter in enumerate(written):
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "/" and depth == 0:
            return written[:index], written[index:].strip("/")
    return written, ""


def _joined(folder: str, path: str) -> str:
    return posixpath.normpath(posixpath.join(folder or ".", path))
