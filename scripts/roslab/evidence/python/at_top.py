"""What a program imports at its top: without it, it does not start."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet
from typing import Literal

from roslab.evidence.facts import Mention
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.python.imports import modules_of
from roslab.evidence.python.modules import Module, modules, run_by_pages
from roslab.evidence.python.through_modules import of_tree
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024


_INSTALLED = pattern(r"\b(?:catkin_install_python|install)[ \t]*\(\s*PROGRAMS\b([^()]{1,4000})\)", re.IGNORECASE)
_PROGRAM = pattern(r"[\w./-]+\.py\b")
_INSTALLS = pattern(
    r"\b(?:install|ament_python_install_(?:package|module))[ \t]*\(\s*(DIRECTORY\b)?([^()]{1,4000})\)", re.IGNORECASE
)
_AMENT = "ament_package"
_VARIANT = 2
"""Fewest words of a name that another one begins with by more than chance."""


def read(
    repository: Repository,
    mentions: Iterable[Mention],
    launched: Iterable[LaunchFile],
    projects: Iterable[PythonProject],
) -> Iterator[Mention]:
    """Yield the modules that programs import under no condition, with the place of the first import in each.

    Of those that pages run what they import themselves; of nodes, which launch files start and CMake or the setup.py
    beside a package.xml installs, what modules of the tree import for them, too. With its own topic what is a
    module of the tree that was not committed, by the names of those beside it, the first of which is its text; and a
    module beside a program that CMake installs without it, for ROS 2: only a link to the source finds it.
    """
    run = run_by_pages(mentions)
    for module in modules(repository) if run else ():
        if module.file.path in run:
            yield from _of(module, "at_top")
    nodes = {*_started(launched), *_installed(repository), *_entries(repository, projects)}
    starting = [module.file.path for module in modules(repository) if module.file.path in nodes] if nodes else []
    reached = nodes | of_tree(repository).reached(starting) if starting else frozenset()
    alone = _alone(repository) if reached else {}
    for module in modules(repository) if reached else ():
        if module.file.path in reached:
            beside = of_tree(repository).beside(module.file.path)
            for each in _of(module, "node_import"):
                variant = _variant(each.value, beside)
                yield replace(each, topic="lost_module", text=variant) if variant else each
                if each.value in beside and module.file.path in alone and each.value not in alone[module.file.path]:
                    yield replace(each, topic="left_beside")


def _of(module: Module, topic: Literal["at_top", "node_import"]) -> Iterator[Mention]:
    found: dict[str, int] = {}
    for match in module.statements:
        for name in modules_of(match) if not match["indent"] else ():
            found.setdefault(name, module.text.count("\n", 0, match.start()) + 1)
    for name, line in found.items():
        yield Mention(topic=topic, value=name, source="code", file=module.file.path, line=line, text=f"import {name}")


def _started(launched: Iterable[LaunchFile]) -> Iterator[str]:
    """Yield the programs of Python that launch files start."""
    for launch in launched:
        yield from (file for file in launch.loaded if file.endswith(".py") and file != launch.file)


def _installed(repository: Repository) -> Iterator[str]:
    """Yield the programs of Python that CMake installs."""
    for file in repository.named("CMakeLists.txt"):
        text = repository.read(file, limit=MAX_SIZE)
        for match in _INSTALLED.finditer(text) if "PROGRAMS" in text else ():
            yield from (posixpath.normpath(posixpath.join(file.folder, name)) for name in _PROGRAM.findall(match[1]))


def _alone(repository: Repository) -> dict[str, AbstractSet[str]]:
    """Return the programs that CMake copies out of their folder for ROS 2, with the names of all that it installs."""
    found: dict[str, AbstractSet[str]] = {}
    for file in repository.named("CMakeLists.txt"):
        text = repository.read(file, limit=MAX_SIZE)
        if "PROGRAMS" not in text or _AMENT not in text:
            continue
        calls = [(bool(match[1]), match[2].replace('"', " ").split()) for match in _INSTALLS.finditer(text)]
        names = {word.rstrip("/").rpartition("/")[2].removesuffix(".py") for _, words in calls for word in words}
        folders = {word.rstrip("/") for whole, words in calls if whole for word in words}
        for match in _INSTALLED.finditer(text):
            programs = (name.removeprefix("./") for name in _PROGRAM.findall(match[1]))
            found |= {posixpath.join(file.folder, p): names for p in programs if posixpath.dirname(p) not in folders}
    return found


def _entries(repository: Repository, projects: Iterable[PythonProject]) -> Iterator[str]:
    """Yield the files of the modules that packages of ROS in Python install as programs."""
    for project in projects:
        if project.modules and repository.has(posixpath.join(project.folder, "package.xml")):
            for module in project.modules:
                path = f"{module.replace('.', '/')}.py"
                yield from (posixpath.join(project.folder, path), posixpath.join(project.folder, "src", path))


def _variant(name: str, beside: AbstractSet[str]) -> str:
    """Return the first module beside one that is not there which is called as a variant of it is, else ``""``.

    ``net_dense_flat`` is one of ``net_dense``, and the other way round; ``net_dense_old`` is another thing, as packages
    of one family are that begin alike.
    """
    words = name.split("_")
    alike = (each for each in sorted(beside) if _contains(words, each.split("_")))
    return "" if name in beside else next(alike, "")


def _contains(one: list[str], other: list[str]) -> bool:
    """Tell whether the longer of two names begins with the whole of the shorter one, which is no single word."""
    fewest = min(len(one), len(other))
    return fewest >= _VARIANT and one[:fewest] == other[:fewest]
