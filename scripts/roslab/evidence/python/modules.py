"""The Python modules of a tree: each is read, and its words are found, once for all who look for something in it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from roslab.evidence import places
from roslab.evidence.copied_libraries import folders_of_copies, in_copy
from roslab.evidence.facts import Mention
from roslab.evidence.python.statements import statements
from roslab.evidence.python.unsuffixed import unsuffixed
from roslab.knowledge.hints import words_of
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MAX_READ = 128 * 1024
"""Bytes of a module that are searched: imports are at its top."""
MAX_MODULES = 6_000
"""Most modules opened, those nearest to the root first."""
_SETUP = "setup.py"
_SPHINX = ("html_theme", "master_doc", "root_doc", "sphinx.ext")
_ROS = pattern(r"py(?<=r(?:os|cl)py)")


@dataclass(frozen=True, kw_only=True)
class Module:
    """A module of a repository."""

    file: File
    repository: Repository

    @cached_property
    def text(self) -> str:
        """Its code, or the beginning of it."""
        return self.repository.read(self.file, limit=MAX_READ)

    @cached_property
    def words(self) -> frozenset[str]:
        """The names in it that are hints."""
        return words_of(self.text)

    @cached_property
    def statements(self) -> tuple[re.Match[str], ...]:
        """Those of it that import."""
        return tuple(statements(self.text))

    @cached_property
    def names_ros(self) -> bool:
        """Whether the library of ROS's nodes stands anywhere in it."""
        return bool(_ROS.search(self.text))


def modules(repository: Repository) -> tuple[Module, ...]:
    """Return the modules worth reading, nearest to the root first; vendored code, documentation and CI are left out.

    Programs whose first line names Python are among them, whatever ending their names lack; nothing imports these.
    """
    return repository.once(_modules)


def run_by_pages(mentions: Iterable[Mention]) -> set[str]:
    """Return the files of Python that the commands of pages start, and the examples in a folder that one names."""
    run = (file for said in mentions if said.topic in {"command", "shown"} for file in said.files)
    return {file for file in run if file.endswith(".py")}


def has_guard(module: Module) -> bool:
    """Tell whether a module begins a program where it is started itself, and is no test."""
    return "__main__" in module.words and not places.test(module.file.path)


def setup_scripts(repository: Repository) -> tuple[Module, ...]:
    """Return every setup.py worth reading, as ``modules`` returns the rest."""
    return repository.once(_setup_scripts)


def _modules(repository: Repository) -> tuple[Module, ...]:
    return tuple(module for module in repository.once(_all) if module.file.name != _SETUP and not _of_sphinx(module))


def _of_sphinx(module: Module) -> bool:
    """Tell whether a module configures Sphinx, whatever its folder is called: no program needs what that calls.

    https://www.sphinx-doc.org/en/master/usage/configuration.html, 2026-11-27.
    """
    return module.file.name == "conf.py" and any(name in module.text for name in _SPHINX)


def _setup_scripts(repository: Repository) -> tuple[Module, ...]:
    return tuple(module for module in repository.once(_all) if module.file.name == _SETUP)


def _all(repository: Repository) -> tuple[Module, ...]:
    copies = folders_of_copies(repository)
    kept = [
        file
        for file in (*repository.suffixed(".py"), *unsuffixed(repository))
        if not places.vendored(file.path) and not places.documentation(file.path) and file.size < 16 * MAX_READ
        if not in_copy(file.path, copies)
    ]
    return tuple(Module(file=file, repository=repository) for file in nearest(kept)[:MAX_MODULES])
