"""Folders of the author's own computer in CMake files: what the build takes from them is in no image."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from roslab.evidence import places
from roslab.evidence.lex.cmake import calls
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_FILES = 300
"""Most CMake files that are searched, those nearest to the root first."""
MAX_SIZE = 64 * 1024
_PATH = r"(/(?:home|Users)/[A-Za-z][\w.-]*/[\w./+-]*)"
_HOME = pattern(rf"^[^#\n]*?(?<![\w/}}]){_PATH}")
_DEFINING = frozenset({"target_compile_definitions", "add_compile_definitions", "add_definitions"})
_DEFINED = pattern(rf"(?:-D|(?<=\s))([A-Za-z_]\w*)=[\\\"']*{_PATH}")
_CODE = (".c", ".cc", ".cpp", ".cxx", ".cu", ".h", ".hh", ".hpp", ".hxx", ".cuh", ".in")
_TAKEN = "what the build takes from there is not in the image; put it under `source` in roslab.yaml"
_READ = (
    "the code has it as {}, and what it reads there when it runs is not in the image; mount it, or write a path of the "
    "tree"
)


def read(repository: Repository, meant: Collection[tuple[str, int]] = ()) -> Iterator[tuple[str, str, int]]:
    """Yield what the author should know of the first such folder: the message, the file and the line.

    ``meant``: files and lines that name what the tree has, to which a link leads.
    """
    files = (f for f in repository.named("CMakeLists.txt") if f.size <= MAX_SIZE and not places.vendored(f.path))
    kept = [f for f in files if not places.test(f.path) and not places.example(f.path)]
    first: tuple[str, str, int, str] | None = None
    found = 0
    for file in sorted(kept, key=lambda f: (f.path.count("/"), f.path))[:MAX_FILES]:
        text = repository.read(file)
        macros = _macros(text) if "/home/" in text or "/Users/" in text else {}
        unused = {path for path, macro in macros.items() if not _used(macro, repository)}
        for number, line in enumerate(text.split("\n"), 1) if "/home/" in text or "/Users/" in text else ():
            match = _HOME.match(line)
            if match and (file.path, number) not in meant and match[1] not in unused:
                found += 1
                first = first or (match[1], file.path, number, macros.get(match[1], ""))
    if first:
        more = f", and so are {found - 1} more" if found > 2 else ", and so is one more" if found > 1 else ""
        why = _READ.format(first[3]) if first[3] else _TAKEN
        yield f"{first[0]} is a folder of its author's computer{more}: {why}", first[1], first[2]


def _macros(text: str) -> dict[str, str]:
    """Return the macros that a file of CMake defines as such folders, by these."""
    defined = (" ".join(call.written).replace("= ", "=") for call in calls(text, _DEFINING))
    return {match[2]: match[1] for words in defined for match in _DEFINED.finditer(words)}


def _used(macro: str, repository: Repository) -> bool:
    """Tell whether code of the tree names a macro, outside of a comment of one line."""
    word = re.compile(rf"^(?:(?!//)[^\n])*?\b{macro}\b", re.MULTILINE)
    return any(word.search(text) for file in repository.suffixed(*_CODE) if macro in (text := repository.read(file)))
