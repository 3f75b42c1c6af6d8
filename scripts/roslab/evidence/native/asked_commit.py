"""CMake that asks git for the commit of its own source, and does not compile without an answer.

https://cmake.org/cmake/help/latest/command/execute_process.html, 2026-11-28.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 100
"""Most files of CMake that are looked at, those nearest to the root first."""
_DEFINES = frozenset({"add_definitions", "add_compile_definitions", "target_compile_definitions"})
_CALLS = frozenset({"execute_process", "message", *_DEFINES})
_ASKS = pattern(
    r"(?i)(?<![\w./-])(?:\$\{git_executable\}|git)(?=\s)[^|;&]{0,200}?\s"
    r"(?:rev-parse|rev-list|log|show|branch|submodule|status)\s"
)
"""What answers where there is a commit: the folder of an image has no tags, which ``git describe`` looks for."""
_OUTPUT, _RESULT, _FATAL = "OUTPUT_VARIABLE", "RESULT_VARIABLE", "COMMAND_ERROR_IS_FATAL"


def asked_commit(repository: Repository) -> Iterator[tuple[File, int, str]]:
    """Yield each such call of CMake with its file, its line and what it asks.

    What it says goes to the compiler as a bare value, which is nothing without a commit, or its failure stops CMake,
    as that of ``git submodule update`` may.
    """
    files = [
        file for file in repository.named("CMakeLists.txt") if file.size <= MAX_SIZE and not places.aside(file.path)
    ]
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        if "execute_process" in text.lower() and "git" in text.lower():
            made = tuple(calls(text, _CALLS))
            yield from ((file, call.line, said) for call in made if (said := _asks(call)) and _needed(call, made))


def _asks(call: Call) -> str:
    """Return what a call asks git, also by a shell; ``""`` for none, and for what is only done where there is .git."""
    if call.name != "execute_process" or any(".git" in condition for condition in call.conditions):
        return ""
    found = _ASKS.search(f"{' '.join(call.words)} ")
    return found[0].strip() if found else ""


def _needed(call: Call, made: Sequence[Call]) -> bool:
    """Tell whether CMake stops where git does not answer, or hands a bare value to the compiler: ``-DCOMMIT=${ID}``."""
    output, result = _behind(_OUTPUT, call), _behind(_RESULT, call)
    stops = re.compile(rf"(?<!\w){re.escape(result)}(?!\w)") if result else None
    for other in made:
        told = output and other.name in _DEFINES and any(word.endswith(f"=${{{output}}}") for word in other.words)
        if told and not any(output in condition for condition in other.conditions):
            return True
        fatal = other.name == "message" and other.words[:1] == ("FATAL_ERROR",) and other.line > call.line
        if stops and fatal and any(map(stops.search, other.conditions[-1:])):
            return True
    return _FATAL in call.words


def _behind(keyword: str, call: Call) -> str:
    """Return the word behind a keyword of a call, ``""`` without one."""
    at = call.words.index(keyword) + 1 if keyword in call.words else len(call.words)
    return "".join(call.words[at : at + 1])
