"""Libraries that ``find_library`` looks for and that a target is always linked with: CMake stops without them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.lex.lines import lines_with
from roslab.evidence.native.x86_searched import wanted
from roslab.knowledge.libraries import library
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

SEARCHED = "searched"
"""The role of a library that CMake looks for by its name and stops without."""
_FIND = "find_library"
_CALLS = frozenset({_FIND, "target_link_libraries", "link_libraries"})
_VARIABLE = pattern(r"\$\{(\w+)\}")
_CONDITION = pattern(r"\s*(?:else)?if\s*\(")
_STOPS = pattern(r"\s*if\s*\(\s*NOT\s+(\w+)\s*\)\s*message\s*\(\s*(?:FATAL|SEND)_ERROR\b", re.IGNORECASE)
_FILE = pattern(r"^(?:lib)?([\w+.-]+?)\.(?:so(?:\.\d+)*|a)$")
"""https://cmake.org/cmake/help/latest/command/find_library.html: a name may be that of the file."""


def searched(text: str, path: str, repository: Repository) -> Iterator[Dependency]:
    """Yield each such library that the tree does not hold, under the name that a table knows, else the first.

    Where a condition asks whether it was found, or stands before the search, CMake may go on without it; not where all
    that the condition does is to stop.
    """
    if _FIND not in text.lower():
        return
    found: dict[str, list[Call]] = {}
    linked: set[str] = set()
    for call in calls(text, _CALLS):
        if call.name == _FIND and call.words:
            found.setdefault(call.words[0], []).append(call)
        elif not (call.conditions or call.in_function):
            linked.update(name for word in call.words for name in _VARIABLE.findall(word))
    for variable, looking in found.items():
        sure = not any(call.conditions or call.in_function for call in looking)
        used = variable in linked or any("REQUIRED" in call.words for call in looking)
        names = [_plain(name) for call in looking for name in wanted(call)]
        if sure and used and names and not (_asked(text, variable) or any(held(name, repository) for name in names)):
            name = next((name for name in names if _known(name)), names[0])
            role = "test" if places.test(path) else SEARCHED
            yield Dependency(namespace="link", name=name, strength="used", file=path, line=looking[0].line, role=role)


def _plain(name: str) -> str:
    """Return the name by which the linker knows a library."""
    match = _FILE.match(name)
    return match[1] if match else name.removeprefix("-l")


def _asked(text: str, variable: str) -> bool:
    """Tell whether a condition names a variable."""
    starts = (text.rfind("\n", 0, at) + 1 for at in lines_with(text, variable))
    return any(_CONDITION.match(text, start) and not _stops(text, start, variable) for start in starts)


def _stops(text: str, start: int, variable: str) -> bool:
    found = _STOPS.match(text, start)
    return found is not None and found[1] == variable


def held(name: str, repository: Repository) -> bool:
    """Tell whether the tree has the file of a library, or its name is not known."""
    return bool(repository.named(f"lib{name}.so", f"lib{name}.a")) or "$" in name


def _known(name: str) -> bool:
    return any(library(naming, name, None) is not None for naming in ("link", "cmake"))
