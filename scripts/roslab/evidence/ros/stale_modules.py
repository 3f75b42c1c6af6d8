"""Entries of .gitmodules for which the commit records nothing: whether anything of the tree names the folder."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.ros.clonable import can_be_cloned
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

_FILES = ("CMakeLists.txt", "package.xml", "setup.py", "setup.cfg", "pyproject.toml", "Dockerfile", "Makefile")
_SUFFIXES = (".py", ".cmake", ".txt", ".yml", ".yaml", ".sh", ".launch", ".ipynb")
_PAGES = (".md", ".rst")
MAX_SIZE = 128 * 1024
MAX_FILES = 1_000
"""Most files that are searched, those nearest to the root first."""
_STEP = pattern(r"\bcd\s|\binstall\b|\bcmake\b|\bmake\b|\bcolcon\b|\bcatkin\b|-e\s|PYTHONPATH|submodule")
"""What a line of a page does with a folder that it needs."""


def named(repository: Repository, path: str) -> bool:
    """Tell whether a build file, a program or a step of a page names a submodule by its path or its last folder.

    Beside packages of ROS it may hold one that they need by another name.
    """
    if repository.named("package.xml", "manifest.xml"):
        return True
    name, told = path.rpartition("/")[2], repository.once(_told)
    if name not in told:
        word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
        told[name] = any(_names(text, name, word, page) for text, page in repository.once(_texts))
    return told[name]


def _told(_: Repository) -> dict[str, bool]:
    """Return where the answers are kept, by the names of folders."""
    return {}


def _texts(repository: Repository) -> tuple[tuple[str, bool], ...]:
    """Return the text of each file that is searched, and whether it is a page."""
    files = [*repository.named(*_FILES), *repository.suffixed(*_SUFFIXES, *_PAGES)]
    files = [file for file in files if 0 < file.size <= MAX_SIZE and not places.vendored(file.path)]
    return tuple((repository.read(file), file.name.lower().endswith(_PAGES)) for file in nearest(files)[:MAX_FILES])


def _names(text: str, name: str, word: re.Pattern[str], page: bool) -> bool:
    """Tell whether a text has a name as a word; a page after what does something with the folder, in one line."""
    if name not in text:
        return False
    if not page:
        return bool(word.search(text))
    for line in text.split("\n"):
        last = max((match.start() for match in word.finditer(line)), default=0) if name in line else 0
        if last and _STEP.search(line, 0, last):
            return True
    return False


def fate(repository: Repository, module: GitSource) -> str:
    """Return what becomes of such an entry."""
    if not named(repository, module.name):
        return "nothing names it, and it is left out"
    return "the image clones its newest state" if can_be_cloned(module) else "the image cannot clone it either"
