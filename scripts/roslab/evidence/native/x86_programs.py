"""Programs for x86-64 that lie compiled in the tree and that code in C or C++ starts by their path."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.native.x86 import cmake_files
from roslab.evidence.x86_only import X86Only
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MOST = 300
"""Most files that may be programs of which the beginning is read, those nearest to the root first."""
MAX_CODE = 3_000
SMALLEST = 4 * 1024
_NAME = pattern(r"[A-Za-z][\w.+-]{1,80}")
_SUFFIXES = frozenset({"", ".bin", ".elf", ".out", ".x86_64"})
_HEAD = 20
_ELF, _X86_64, _PROGRAMS = b"\x7fELF", b"\x3e\x00", (b"\x02\x00", b"\x03\x00")
"""https://refspecs.linuxfoundation.org/elf/gabi4+/ch4.eheader.html, read 2026-11-27"""
_CODE = (".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp")
_STARTS = pattern(r"\b(?:system|popen|execl[pe]?|execvp?e?|posix_spawnp?)\s*\(")
"""https://man7.org/linux/man-pages/man3/system.3.html https://man7.org/linux/man-pages/man3/exec.3.html"""
_CHOOSES = pattern(r"__aarch64__|__arm__|__x86_64__|\buname\b")


def read(repository: Repository) -> Iterator[X86Only]:
    """Yield the first such program that code starts, and that no file of CMake names: that may make it."""
    found = programs(repository)
    if not found:
        return
    code = (file for file in repository.suffixed(*_CODE)[:MAX_CODE] if not places.aside(file.path))
    for file in code:
        text = repository.read(file)
        if not _STARTS.search(text) or _CHOOSES.search(text):
            continue
        for name, path in found.items():
            # ./NAME or FOLDER/NAME, at the beginning of what a shell reads or in the midst of it
            called = re.search(rf'"[^"\n]*/{re.escape(name)}(?=["\s\\;&|])', text) if name in text else None
            if called and not _made(name, repository):
                yield X86Only(path, "started", file.path, text.count("\n", 0, called.start()) + 1)
                return


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
    head = repository.read_bytes(file.path, limit=_HEAD)
    return head[:4] == _ELF and head[16:18] in _PROGRAMS and head[18:20] == _X86_64


def _made(name: str, repository: Repository) -> bool:
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return any(word.search(repository.read(file)) for file in cmake_files(repository))
