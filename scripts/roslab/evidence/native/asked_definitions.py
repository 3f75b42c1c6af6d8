"""Options without which CMake of the tree stops: ``if(NOT DEFINED SDK_ROOT)`` around a ``message(FATAL_ERROR …)``."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.hidden import hidden
from roslab.evidence.lex.cmake import calls
from roslab.evidence.lex.constants import may_be_set
from roslab.evidence.native.asked_variables import said, stops
from roslab.repository.checkout import Repository, nearest
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_PACKAGES = 60
"""Most packages that are looked into, those nearest to the root first."""
MOST = 20
"""Most options."""
_UNSET = pattern(r"NOT DEFINED (?!CMAKE_|BUILD_|ROS_)([A-Za-z]\w+)")
_SIGN = pattern(r"(?i)\bNOT\s+DEFINED\b")


@dataclass(frozen=True, kw_only=True, slots=True)
class Definition:
    """A variable of CMake that nothing in the tree sets, with the error that a build without it ends with."""

    name: str
    file: str
    line: int
    said: str

    @property
    def folder(self) -> str:
        """The folder of the project."""
        return self.file.rpartition("/")[0]


def read(repository: Repository) -> Iterator[Mention]:
    """Yield ``-DNAME`` for each."""
    for each in repository.once(definitions):
        value = f"-D{each.name}"
        yield Mention(topic="demanded", value=value, source="code", file=each.file, line=each.line, text=each.said)


def definitions(repository: Repository) -> tuple[Definition, ...]:
    """Return what CMake at the root and of the tree's packages of ROS demands, by ``if(NOT DEFINED X)`` alone."""
    folders = {"", *(file.folder for file in repository.named("package.xml"))}
    folders = {folder for folder in folders if not hidden(repository, folder)}
    files = [file for file in repository.named("CMakeLists.txt") if file.folder in folders]
    files = nearest([file for file in files if file.size <= MAX_SIZE and not places.aside(file.path)])[:MAX_PACKAGES]
    found = list(islice((each for file in files for each in _of(repository.read(file), file.path)), MOST))
    if not found:
        return ()
    modules = [file for file in repository.suffixed(".cmake") if file.size <= MAX_SIZE]
    included = [repository.read(file) for file in nearest(modules)[:MAX_PACKAGES]]
    presets = "".join(repository.read(file) for file in repository.named("CMakePresets.json"))
    free = (each for each in found if f'"{each.name}"' not in presets)
    return tuple(each for each in free if not any(may_be_set(text, each.name) for text in included))


def _of(text: str, file: str) -> Iterator[Definition]:
    if "FATAL_ERROR" not in text or not _SIGN.search(text):
        return
    for name, call in stops(calls(text, frozenset({"message"})), _UNSET):
        if not may_be_set(text, name):
            yield Definition(name=name, file=file, line=call.line, said=said(call))
