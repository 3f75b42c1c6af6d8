"""Copied code with a ``configure`` that files of CMake run, and that looks for a compiler of Fortran."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

COMPILER = "gfortran"
NAME = "configure"
_RUNNING = frozenset({"execute_process", "externalproject_add", "add_custom_command", "add_custom_target"})
_MADE_OF = (f"{NAME}.ac", f"{NAME}.in")
_SCRIPT = pattern(r"^(?:\$\{\w+\}/)?(?:\./)?((?:[\w.+-]+/)*)configure$")
_FORTRAN = pattern(r"\bAC_(?:\w+_)?PROG_(?:F77|FC)\b")
"""https://www.gnu.org/software/autoconf/manual/autoconf.html#Fortran-Compiler; COIN's is AC_COIN_PROG_F77."""
MAX_SCRIPT = 1024 * 1024


def read(repository: Repository) -> Iterator[Dependency]:
    """Yield the compiler at the first call that runs such a script of the tree, itself or one below it."""
    if not repository.named(NAME):
        return
    for file in cmake_files(repository):
        text = repository.read(file)
        for call in calls(text, _RUNNING) if NAME in text and not places.vendored(file.path) else ():
            if any(_looks(folder, repository) for folder in _folders(call, file.folder, repository)):
                yield Dependency(
                    namespace="apt", name=COMPILER, strength="used", file=file.path, line=call.line, role="configure"
                )
                return


def _folders(call: Call, folder: str, repository: Repository) -> Iterator[str]:
    """Yield the folders of the tree whose script a call runs: below the root or below its file's folder."""
    for match in filter(None, map(_SCRIPT.match, call.words)):
        place = match[1].rstrip("/")
        for above in dict.fromkeys(("", f"{folder}/" if folder else "")):
            path = f"{above}{place}"
            if place and repository.has(f"{path}/{NAME}"):
                yield path


def _looks(folder: str, repository: Repository) -> bool:
    """Tell whether a script looks for the compiler, by what it was made of, by its own words where that is not there.

    Old versions of libtool look for one in every script.
    """
    made_of = [file for file in repository.named(*_MADE_OF) if file.path.startswith(f"{folder}/")]
    if made_of:
        return any(_FORTRAN.search(repository.read(file)) for file in made_of)
    return COMPILER in repository.read(f"{folder}/{NAME}", limit=MAX_SCRIPT)
