"""Repositories that files of CMake clone without a commit or a tag: each build takes their newest commit."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

TOPIC = "cloned_head"
_FETCHING = frozenset({"fetchcontent_declare", "externalproject_add"})
_RUNNING = frozenset({"execute_process", "exec_program", "add_custom_command", "add_custom_target"})
_NEWEST = frozenset({"master", "main", "develop", "HEAD"})
_URL = pattern(r"(?:https?|git|ssh)://\S+$|git@[\w.-]+:\S+$")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such clone that a file of CMake always makes, once."""
    told: set[str] = set()
    for file in cmake_files(repository):
        text = repository.read(file)
        if places.vendored(file.path) or not ("GIT_REPOSITORY" in text or "clone" in text):
            continue
        for call in calls(text, _FETCHING | _RUNNING):
            url = _fetched(call) if call.name in _FETCHING else _cloned(call)
            if url and url not in told:
                told.add(url)
                yield Mention(topic="cloned_head", value=url, source="code", file=file.path, line=call.line, text=url)


def _fetched(call: Call) -> str | None:
    """Return the address of what is fetched without a tag, or at the usual name of the newest branch."""
    values = dict(pairwise(call.words))
    url, ref = values.get("GIT_REPOSITORY"), values.get("GIT_TAG")
    return url if url and _URL.match(url) and (ref is None or ref in _NEWEST) else None


def _cloned(call: Call) -> str | None:
    """Return the address of what ``git clone`` brings; one at a branch, or of which a part is brought, is none."""
    words = [part for word in call.words for part in word.split()]
    if not any(pair == ("git", "clone") for pair in pairwise(words)) or {"-b", "--branch", "checkout"} & {*words}:
        return None
    return next((word for word in words if _URL.match(word)), None)
