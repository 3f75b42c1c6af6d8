"""Programs that ``find_program`` looks for and that CMake stops without."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.cmake_needs import made_here
from roslab.knowledge.compiled import programs
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_FIND = "find_program"
_CALLS = frozenset({_FIND, "message"})
_STOPS = frozenset({"FATAL_ERROR", "SEND_ERROR"})
_OPTION = pattern(r"[A-Z][A-Z_]{3,}$")
_NAME = pattern(r"[\w.+-]+$")
_PYTHON = pattern(r"python[\d.]*$")
"""Every image has one, whichever it is."""


def searched_programs(text: str, path: str, repository: Repository) -> Iterator[Dependency]:
    """Yield each such program that the tree does not hold, under the first name that a table knows, else the first.

    The search says ``REQUIRED``, or all that follows where it found none is to stop. Of several names one is enough,
    which every image may have.
    """
    if _FIND not in text.lower():
        return
    found: dict[str, list[Call]] = {}
    stops: list[str] = []
    for call in calls(text, _CALLS):
        if call.name == _FIND and call.words and not call.in_function:
            found.setdefault(call.words[0], []).append(call)
        elif call.name == "message" and call.words[:1] and call.words[0] in _STOPS:
            stops += call.conditions[-1:] if made_here(call.conditions[:-1]) else ()
    for variable, looking in found.items():
        required = any("REQUIRED" in call.words and made_here(call.conditions) for call in looking)
        asked = made_here(looking[0].conditions) and not _unfound(variable).isdisjoint(stops)
        names = [name for call in looking for name in _names(call)]
        here = any(_there(name, repository) for name in names)
        if (required or asked) and names and not here:
            name = next((name for name in names if name in programs()), names[0])
            role = "test" if places.test(path) else "program"
            yield Dependency(
                namespace="program", name=name, strength="declared", file=path, line=looking[0].line, role=role
            )


def _names(call: Call) -> Iterator[str]:
    """Yield the names of the program; without ``NAMES`` there is one, and what follows it are folders.

    https://cmake.org/cmake/help/latest/command/find_program.html
    """
    words = call.words[1:]
    for word in words[1:] if words[:1] == ("NAMES",) else words[:1]:
        if _OPTION.match(word):
            return
        yield word


def _there(name: str, repository: Repository) -> bool:
    """Tell whether every image has a program, or the tree has its file, or its name is not known."""
    from roslab.knowledge.base_programs import base_programs  # noqa: PLC0415 - few projects search programs

    of_base = name in base_programs() or _PYTHON.match(name)
    return bool(of_base) or not _NAME.match(name) or bool(repository.named(name))


def _unfound(variable: str) -> frozenset[str]:
    """Return the conditions that hold where a search found nothing."""
    forms = [f"NOT {variable}", f"NOT ({variable})", f"NOT (${{{variable}}})", f"NOT ${{{variable}}}"]
    for left in (variable, f"${{{variable}}}"):
        forms += [f"{left} {word} {variable}-NOTFOUND" for word in ("STREQUAL", "MATCHES", "EQUAL")]
        forms += [f"{left} MATCHES NOTFOUND", f"{left} MATCHES .*-NOTFOUND"]
    return frozenset(forms)
