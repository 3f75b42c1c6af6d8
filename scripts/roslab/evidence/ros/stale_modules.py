"""Entries of .gitmodules for which the commit records nothing: whether anything of the tree names the folder."""

from __future__ import annotations

import re
from collections.abc import Iterable

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


def elsewhere(repository: Repository, module: GitSource, there: Iterable[GitSource]) -> str:
    """Return where the commit has the same repository under another path, if nothing names the path of this entry.

    ``there``: the submodules that it has.
    """
    same = (each.name for each in there if each.name != module.name and _bare(each.url) == _bare(module.url))
    path = next(same, "")
    return "" if path and any(module.name in text for text, _ in repository.once(_texts)) else path


def _bare(url: str) -> str:
    return url.rstrip("/").removesuffix(".git").lower()


def fate(repository: Repository, module: GitSource, there: Iterable[GitSource]) -> str:
    """Return what becomes of such an entry beside the submodules that are ``there``."""
    if not named(repository, module.name):
        return "nothing names it, and it is left out"
    if path := elsewhere(repository, module, there):
        return f"{path} is of the same repository, and it is left out"
    return "the image clones its newest state" if can_be_cloned(module) else "the image cannot clone it either"
