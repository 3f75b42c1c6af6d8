"""Programs for x86-64 that lie compiled in the tree and that code in C or C++ starts by their path."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from roslab.evidence import places
from roslab.evidence.native import elf
from roslab.evidence.native.x86 import cmake_files
from roslab.evidence.native.x86_binaries import CHOOSES_IN_CODE, CODE, MAX_CODE
from roslab.evidence.x86_only import X86Only
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MOST = 300
"""Most files that may be programs of which the beginning is read, those nearest to the root first."""
MAX_VARIABLES = 50
SMALLEST = 4 * 1024
_NAME = pattern(r"[A-Za-z][\w.+-]{1,80}")
_SUFFIXES = frozenset({"", ".bin", ".elf", ".out", ".x86_64"})
_STRING = r"\"(?:[^\"\\\n]|\\.)*\""
_REST = rf"((?:{_STRING}|[^\";{{}}]){{0,400}})"
"""The rest of a statement, with its strings."""
_STARTS = pattern(rf"\b(?:system|popen|execl[pe]?|execvp?e?|posix_spawnp?)\s*\({_REST}")
"""https://man7.org/linux/man-pages/man3/system.3.html https://man7.org/linux/man-pages/man3/exec.3.html"""
_TEXT = pattern(_STRING)
_VARIABLE = pattern(r"[A-Za-z_]\w*")
_NO_VARIABLES = frozenset({"c_str", "str", "data", "std", "string", "const", "char", "int", "NULL", "nullptr"})
_BETWEEN = pattern(r"[\s\"'\\;&|()=]+")
"""What is between the words of a shell; the backslash is C's."""
_OF_SYSTEM = pattern(r"/(?:usr|bin|sbin|lib\w*|opt|snap|etc)/.*")


def read(repository: Repository) -> Iterator[X86Only]:
    """Yield the first such program that code starts, and that no file of CMake names: that may make it."""
    found = programs(repository)
    if not found:
        return
    code = (file for file in repository.suffixed(*CODE)[:MAX_CODE] if not places.aside(file.path))
    for file in code:
        text = repository.read(file)
        if CHOOSES_IN_CODE.search(text):
            continue
        for position, string in _given(text):
            name = _called(string, found, joined=text[max(0, position - 20) : position].rstrip().endswith(("+", "<<")))
            if name and not _made(name, repository):
                yield X86Only(found[name], "started", file.path, text.count("\n", 0, position) + 1)
                return


def _given(text: str) -> Iterator[tuple[int, str]]:
    """Yield the strings that calls which start programs get, by themselves or in a variable, with their positions."""
    names: set[str] = set()
    for call in _STARTS.finditer(text):
        yield from ((call.start(1) + string.start(), string[0]) for string in _TEXT.finditer(call[1]))
        names.update(_VARIABLE.findall(_TEXT.sub("", call[1])))
    if names := names - _NO_VARIABLES:
        set_to = re.compile(rf"\b(?:{'|'.join(sorted(names)[:MAX_VARIABLES])})\b[^\";{{}}]{{0,200}}\{{?{_REST}")
        for statement in set_to.finditer(text):
            yield from ((statement.start(1) + string.start(), string[0]) for string in _TEXT.finditer(statement[1]))


def _called(string: str, found: Mapping[str, str], *, joined: bool) -> str:
    """Return the program of the tree that a string calls by a path: ./NAME, FOLDER/NAME; ``joined``: after a folder."""
    for word in _BETWEEN.split(string[1:]):
        name = word.rpartition("/")[2]
        if "/" in word and name in found and (joined or not _OF_SYSTEM.fullmatch(word)):
            return name
        joined = False
    return ""


def programs(repository: Repository) -> dict[str, str]:
    """Return the paths of programs for x86-64 in the tree by their names, each once."""
    return repository.once(_programs)


def _programs(repository: Repository) -> dict[str, str]:
    files = [file for file in repository.files if _may_be(file)]
    return {file.name: file.path for file in reversed(nearest(files)[:MOST]) if _is_x86(file, repository)}


def _may_be(file: File) -> bool:
    return (
        file.size >= SMALLEST
        and file.suffix in _SUFFIXES
        and _NAME.fullmatch(file.name) is not None
        and not places.aside(file.path)
    )


def _is_x86(file: File, repository: Repository) -> bool:
    head = repository.read_bytes(file.path, limit=elf.HEADER)
    return elf.machine(head) == elf.X86_64 and elf.starts(head)


def _made(name: str, repository: Repository) -> bool:
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return any(word.search(repository.read(file)) for file in cmake_files(repository))
