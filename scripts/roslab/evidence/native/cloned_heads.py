"""Repositories that files of CMake clone without a commit, by git itself or as a branch: each time their newest one."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import Call, calls
from roslab.evidence.native import templates
from roslab.evidence.native.cmake_needs import made_here
from roslab.evidence.native.x86 import cmake_files
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_RUNNING = frozenset({"execute_process", "exec_program", "add_custom_command", "add_custom_target"})
_FETCHING = frozenset({"fetchcontent_declare", "externalproject_add", "download_project", "cpmaddpackage"})
"""download_project: https://github.com/Crascit/DownloadProject, CPMAddPackage: https://github.com/cpm-cmake/CPM.cmake."""
_OF_CPM = {"GITHUB_REPOSITORY": "https://github.com/", "GITLAB_REPOSITORY": "https://gitlab.com/"}
_SHORT = pattern(r"(gh|gl):([\w.-]+/[\w.-]+)#([\w./-]+)$")
_HOSTS = {"gh": "https://github.com/", "gl": "https://gitlab.com/"}
_BRANCH = pattern(r"(?:(?:origin|remotes/origin|refs/heads)/[\w./-]+|HEAD|[A-Za-z]+(?:[-_/][A-Za-z]+){0,4})$")
"""A ref without a number: a tag of that form stays itself, for a day moves branches alone."""
_ARCHIVE = pattern(
    r"https?://github\.com/[\w.-]+/[\w.-]+/archive/(?:refs/heads/)?[A-Za-z]+(?:[-_/][A-Za-z]+){0,4}\.(?:zip|tar\.gz)$"
)
"""Of a branch, not of a tag with a number or a commit."""
_HEX = pattern(r"[0-9a-f]{7,40}$")
_NAMED = pattern(r"_REPOSITORY\b|CPMAddPackage")
_URL = pattern(r"(?:https?|git|ssh)://\S+$|git@[\w.-]+:\S+$")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each such clone that a file of CMake always makes, once."""
    told: set[str] = set()
    for file in (*cmake_files(repository), *templates.files(repository)):
        text = repository.read(file)
        if places.vendored(file.path) or not ("clone" in text or _NAMED.search(text)):
            continue
        for call in calls(text, _RUNNING | _FETCHING):
            url = _cloned(call) if call.name in _RUNNING else _fetched(call)
            if url and url not in told:
                told.add(url)
                yield Mention(topic="cloned_head", value=url, source="code", file=file.path, line=call.line, text=url)


def archives(repository: Repository) -> Iterator[Mention]:
    """Yield each project that CMake always downloads as the archive of a branch, and compiles with all the others.

    https://cmake.org/cmake/help/latest/module/ExternalProject.html (EXCLUDE_FROM_ALL), 2026-11-29.
    """
    for file in cmake_files(repository):
        text = repository.read(file)
        if "/archive/" not in text or places.vendored(file.path):
            continue
        for call in calls(text, frozenset({"externalproject_add"})):
            url = dict(pairwise(call.words)).get("URL", "")
            asked = call.in_function or "EXCLUDE_FROM_ALL" in call.words or not made_here(call.conditions)
            if not asked and _ARCHIVE.match(url):
                name = call.words[0]
                yield Mention(topic="head_archive", value=name, source="code", file=file.path, line=call.line, text=url)


def _cloned(call: Call) -> str | None:
    """Return the address of what ``git clone`` brings; one at a branch, or of which a part is brought, is none."""
    words = [part for word in call.words for part in word.split()]
    cloned = any(pair == ("git", "clone") for pair in pairwise(words))
    if not cloned or {"-b", "--branch", "--depth", "checkout"} & {*words}:
        return None
    return next((word for word in words if _URL.match(word)), None)


def _fetched(call: Call) -> str | None:
    """Return the address of what a call fetches as it stands on a branch; nothing where the ref is a tag or unknown."""
    given = dict(pairwise(call.words))
    url, ref = given.get("GIT_REPOSITORY", ""), given.get("GIT_TAG")
    if call.name == "cpmaddpackage":
        url = url or next((host + given[name] for name, host in _OF_CPM.items() if name in given), "")
        if short := _SHORT.match(call.words[-1]) if call.words else None:
            url, ref = f"{_HOSTS[short[1]]}{short[2]}", short[3]
        elif ref is None:  # it takes the tag of the version
            return None
    moves = ref is None or (_BRANCH.match(ref) and not _HEX.match(ref))
    return url if moves and _URL.match(url) else None
