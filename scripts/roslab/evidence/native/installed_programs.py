"""Programs that a CMakeLists.txt installs into ``bin``, and into no other folder."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.lex.cmake import Call
from roslab.values.pattern import pattern

BIN = "bin"
_KINDS = frozenset(
    ["ARCHIVE", "LIBRARY", "RUNTIME", "OBJECTS", "FRAMEWORK", "BUNDLE", "PUBLIC_HEADER", "PRIVATE_HEADER", "RESOURCE"]
)
_WORDS = _KINDS | {"EXPORT", "DESTINATION", "COMPONENT", "INCLUDES", "OPTIONAL", "PERMISSIONS", "CONFIGURATIONS"}
_BIN = pattern(r"(?:\$\{CMAKE_INSTALL_PREFIX\}/)?(?:bin|\$\{CMAKE_INSTALL_(?:FULL_)?BINDIR\})/?")


def placed(call: Call) -> Iterator[tuple[str, str]]:
    """Yield the targets that an ``install`` always installs, each with the folder of a program: ``bin``, or as written.

    A program of which the call names no folder goes there by itself. https://cmake.org/cmake/help/latest/command/install.html
    (TARGETS), read 2026-11-28.
    """
    if call.name != "install" or call.words[:1] != ("TARGETS",) or call.conditions or call.in_function:
        return
    words = call.words[1:]
    end = next((index for index, word in enumerate(words) if word in _WORDS), len(words))
    kind, found = "", dict[str, str]()
    for index, word in enumerate(words[end:], end):
        if word in _KINDS:
            kind = word
        elif word == "DESTINATION" and words[index - 1] != "INCLUDES" and index + 1 < len(words):
            found.setdefault(kind, words[index + 1])
    folder = found.get("RUNTIME", found.get("", BIN))
    yield from ((target, BIN if _BIN.fullmatch(folder) else folder) for target in words[:end])


def in_bin(folders: dict[str, set[str]], programs: dict[str, int]) -> tuple[str, ...]:
    """Return the programs that are installed into ``bin`` alone; ``folders``: where each target is installed."""
    return tuple(name for name in programs if folders.get(name) == {BIN})
