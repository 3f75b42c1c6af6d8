"""Libraries that ``find_library`` looks for and that a target is always linked with: CMake stops without them.

And libraries, headers and files whose absence is what a ``message(FATAL_ERROR …)`` waits for.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import takewhile

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.lex.lines import lines_with
from roslab.evidence.native.x86_searched import wanted
from roslab.knowledge.libraries import header, library
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

SEARCHED = "searched"
"""The role of a library that CMake looks for by its name and stops without."""
_FIND = "find_library"
_HEADERS = frozenset({"find_path", "find_file"})
_LOOKS = _HEADERS | {_FIND}
_CALLS = _LOOKS | {"target_link_libraries", "link_libraries", "message"}
_NOT = pattern(r"NOT \(?(\w+)\)?")
_OR = pattern(r"\s+OR\s+")
_ENDING = pattern(r"\.(?:h|hh|hpp|hxx)$")
_OF_SYSTEM = pattern(r"(?:sys|linux|net|netinet|arpa|asm|bits|c\+\+)/")
"""Headers that every compiler has: of the C library, and of the kernel."""
_VARIABLE = pattern(r"\$\{(\w+)\}")
_OPTION = pattern(r"[A-Z][A-Z_]+")
_CONDITION = pattern(r"\s*(?:else)?if\s*\(")
_STOPS = pattern(r"\s*if\s*\(\s*NOT\s+(\w+)\s*\)\s*message\s*\(\s*(?:FATAL|SEND)_ERROR\b", re.IGNORECASE)
_FILE = pattern(r"^(?:lib)?([\w+.-]+?)\.(?:so(?:\.\d+)*|a)$")
"""https://cmake.org/cmake/help/latest/command/find_library.html: a name may be that of the file."""


def searched(text: str, path: str, repository: Repository) -> Iterator[Dependency]:
    """Yield each such library that the tree does not hold, under the name that a table knows, else the first.

    Where a condition asks whether it was found, or stands before the search, CMake may go on without it; not where all
    that the condition does is to stop.
    """
    lowered = text.lower()
    if not any(name in lowered for name in _LOOKS):
        return
    found: dict[str, list[Call]] = {}
    linked: set[str] = set()
    waited: dict[str, str] = {}
    for call in calls(text, _CALLS):
        if call.name in _LOOKS:
            found.setdefault(call.words[0] if call.words else "", []).append(call)
        elif call.name == "message":
            waited |= _waited(call)
        elif not (call.conditions or call.in_function):
            linked.update(name for word in call.words for name in _VARIABLE.findall(word))
    stopped: set[str] = set()
    for variable, looking in sorted(found.items(), key=lambda each: each[1][0].name in _HEADERS):
        if looking[0].name in _HEADERS:
            if (
                waited.get(variable)
                and waited[variable] not in stopped
                and (asked := sought_header(looking, path, repository))
            ):
                yield asked
            continue
        sure = not any(call.conditions or call.in_function for call in looking)
        stops = variable in waited
        used = stops or variable in linked or any("REQUIRED" in call.words for call in looking)
        names = [_plain(name) for call in looking for name in wanted(call)]
        if (
            sure
            and used
            and names
            and not (_asked(text, variable, waited) or any(held(name, repository) for name in names))
        ):
            name = next((name for name in names if known(name)), names[0])
            role = "test" if places.test(path) else SEARCHED
            stopped |= {waited[variable]} if stops else set()
            asked = Dependency(namespace="link", name=name, strength="used", file=path, line=looking[0].line, role=role)
            yield replace(asked, below=tuple(dict.fromkeys(each for call in looking for each in _suffixes(call))))


def _suffixes(call: Call) -> Iterator[str]:
    """Yield the folders below those of all libraries in which a search looks: ``PATH_SUFFIXES acme``."""
    words = call.words[call.words.index("PATH_SUFFIXES") + 1 :] if "PATH_SUFFIXES" in call.words else ()
    yield from takewhile(lambda word: not _OPTION.fullmatch(word), words)


def _waited(call: Call) -> dict[str, str]:
    """Return the variables without any of which a message stops CMake, each with the whole condition."""
    if call.words[:1] != ("FATAL_ERROR",) or len(call.conditions) != 1 or call.in_function:
        return {}
    parts = [_NOT.fullmatch(part) for part in _OR.split(call.conditions[0])]
    return {part[1]: call.conditions[0] for part in parts if part} if all(parts) else {}


def sought_header(looking: list[Call], path: str, repository: Repository) -> Dependency | None:
    """Return the header that a search is for, under the name that a table knows, else the first; none of the tree."""
    names = [name for call in looking for name in wanted(call) if _ENDING.search(name) and "$" not in name]
    inside = any(call.conditions or call.in_function for call in looking)
    if inside or not names or any(_OF_SYSTEM.match(n) or repository.named(n.rpartition("/")[2]) for n in names):
        return None
    name = next((name for name in names if header(name, None) is not None), names[0])
    if "/" not in name and header(name, None) is None:
        return None  # any library may have it, and the C library too
    role = "test" if places.test(path) else SEARCHED
    return Dependency(namespace="include", name=name, strength="used", file=path, line=looking[0].line, role=role)


def _plain(name: str) -> str:
    """Return the name by which the linker knows a library."""
    match = _FILE.match(name)
    return match[1] if match else name.removeprefix("-l")


def _asked(text: str, variable: str, waited: Mapping[str, str]) -> bool:
    """Tell whether a condition names a variable, but for one that only waits to stop."""
    starts = (text.rfind("\n", 0, at) + 1 for at in lines_with(text, variable))
    said = waited.get(variable, "")
    return any(
        _CONDITION.match(text, start) and not (_stops(text, start, variable) or (said and said == _said(text, start)))
        for start in starts
    )


def _said(text: str, start: int) -> str:
    """Return the condition of the line that begins at a place."""
    line = text[start : text.find("\n", start) % (len(text) + 1)]
    return " ".join(line.partition("(")[2].rpartition(")")[0].split())


def _stops(text: str, start: int, variable: str) -> bool:
    found = _STOPS.match(text, start)
    return found is not None and found[1] == variable


def held(name: str, repository: Repository) -> bool:
    """Tell whether the tree has the file of a library, or its name is not known."""
    return bool(repository.named(f"lib{name}.so", f"lib{name}.a")) or "$" in name


def known(name: str) -> bool:
    """Tell whether a table knows a library by its name."""
    return any(library(naming, name, None) is not None for naming in ("link", "cmake"))
