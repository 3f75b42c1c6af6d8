"""Entries of .gitmodules for which the commit records nothing: whether anything of the tree names the folder."""

from __future__ import annotations

import re

from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.ros.clonable import can_be_cloned
from roslab.repository.checkout import Repository

_FILES = ("CMakeLists.txt", "package.xml", "setup.py", "setup.cfg", "pyproject.toml", "Dockerfile", "Makefile")
_SUFFIXES = (".py", ".cmake", ".txt", ".yml", ".yaml", ".sh", ".launch", ".ipynb")
_PAGES = (".md", ".rst")
MAX_SIZE = 128 * 1024
MAX_FILES = 1_000
"""Most files that are searched, those nearest to the root first."""
_STEP = r"(?:\bcd\s|\binstall\b|\bcmake\b|\bmake\b|\bcolcon\b|\bcatkin\b|-e\s|PYTHONPATH|submodule)"
"""What a line of a page does with a folder that it needs."""


def named(repository: Repository, path: str) -> bool:
    """Tell whether a build file, a program or a step of a page names a submodule by its path or its last folder.

    Beside packages of ROS it may hold one that they need by another name.
    """
    if repository.named("package.xml", "manifest.xml"):
        return True
    name = re.escape(path.rpartition("/")[2])
    word = re.compile(rf"(?<![\w-]){name}(?![\w-])")
    step = re.compile(rf"^.*{_STEP}.*(?<![\w-]){name}(?![\w-])", re.MULTILINE)
    files = [*repository.named(*_FILES), *repository.suffixed(*_SUFFIXES, *_PAGES)]
    files = [file for file in files if 0 < file.size <= MAX_SIZE and not places.vendored(file.path)]
    files.sort(key=lambda file: (file.path.count("/"), file.path))
    return any(
        (step if file.name.lower().endswith(_PAGES) else word).search(repository.read(file))
        for file in files[:MAX_FILES]
    )


def fate(repository: Repository, module: GitSource) -> str:
    """Return what becomes of such an entry."""
    if not named(repository, module.name):
        return "nothing names it, and it is left out"
    return "the image clones its newest state" if can_be_cloned(module) else "the image cannot clone it either"
