"""Repositories that files of CMake clone by git itself: each build takes their newest commit.

What FetchContent and ExternalProject fetch is not among them: their update step goes to the newest commit again.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_RUNNING = frozenset({"execute_process", "exec_program", "add_custom_command", "add_custom_target"})
_URL = pattern(r"(?:https?|git|ssh)://\S+$|git@[\w.-]+:\S+$")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such clone that a file of CMake always makes, once."""
    told: set[str] = set()
    for file in cmake_files(repository):
        text = repository.read(file)
        if places.vendored(file.path) or "clone" not in text:
            continue
        for call in calls(text, _RUNNING):
            url = _cloned(call)
            if url and url not in told:
                told.add(url)
                yield Mention(topic="cloned_head", value=url, source="code", file=file.path, line=call.line, text=url)


def _cloned(call: Call) -> str | None:
    """Return the address of what ``git clone`` brings; one at a branch, or of which a part is brought, is none."""
    words = [part for word in call.words for part in word.split()]
    cloned = any(pair == ("git", "clone") for pair in pairwise(words))
    if not cloned or {"-b", "--branch", "--depth", "checkout"} & {*words}:
        return None
    return next((word for word in words if _URL.match(word)), None)
