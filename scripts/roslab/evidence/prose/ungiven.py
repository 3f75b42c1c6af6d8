"""Author's Dockerfiles that build a workspace without an option that CMake of a package demands, and so stop."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from roslab.evidence import places
from roslab.evidence.lex.cmake import calls
from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.prose.built_packages import MAX_SIZE, UNREAD, texts_of, tools
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_PACKAGES = 60
"""Most packages that are looked into, those nearest to the root first."""
_UNSET = pattern(r"NOT DEFINED (?!CMAKE_|BUILD_|ROS_)([A-Za-z]\w+)")
_SIGN = pattern(r"(?i)\bNOT\s+DEFINED\b")
_SELECTS = pattern(r"--packages|\|\||--only-pkg|--pkg\b|\bcatkin[ \t]+(?:build|make)[ \t]+\w")
"""It may build others alone, or go on all the same."""
_OF_COLCON = ("colcon.meta", "defaults.yaml", "colcon-defaults.yaml", "colcon_defaults.yaml")
_IGNORED = ("COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE")


def ungiven(repository: Repository, written: Sequence[Instruction]) -> str | None:
    """Return why a build of the workspace stops, ``None`` where it may not: nothing names what CMake demands."""
    if not (demanded := repository.once(_demanded)):
        return None
    texts = texts_of(repository, written)
    if texts is None or any(map(UNREAD.search, texts)):
        return None
    if not (called := [call for text in texts for call in tools(text)]) or any(map(_SELECTS.search, (*called, *texts))):
        return None
    said = "\n".join((*texts, *(each.text for each in written), *map(repository.read, repository.named(*_OF_COLCON))))
    for name, file, line in demanded:
        if not re.search(rf"(?:\b|-D){re.escape(name)}\b", said):
            return f"it builds the workspace without -D{name}, without which {file} stops (line {line})"
    return None


def _demanded(repository: Repository) -> tuple[tuple[str, str, int], ...]:
    """Return what CMake of the tree's packages demands, by ``if(NOT DEFINED X)`` around an error, with its place."""
    folders = {file.folder for file in repository.named("package.xml")}
    folders -= {file.folder for file in repository.named(*_IGNORED)}
    files = [file for file in repository.named("CMakeLists.txt") if file.folder in folders]
    files = nearest([file for file in files if file.size <= MAX_SIZE and not places.aside(file.path)])[:MAX_PACKAGES]
    found = tuple((name, file.path, line) for file in files for name, line in _of(repository.read(file)))
    included = [repository.read(file) for file in repository.suffixed(".cmake")[:MAX_PACKAGES]] if found else []
    return tuple(each for each in found if not any(_is_set(each[0], text) for text in included))


def _of(text: str) -> Iterator[tuple[str, int]]:
    if "FATAL_ERROR" not in text or not _SIGN.search(text):
        return
    for call in calls(text, frozenset({"message"})):
        unset = _UNSET.fullmatch(call.conditions[0]) if len(call.conditions) == 1 else None
        if unset and call.words[:1] == ("FATAL_ERROR",) and not call.in_function and not _is_set(unset[1], text):
            yield unset[1], call.line


def _is_set(name: str, text: str) -> bool:
    """Tell whether a call other than a condition may set a variable: ``option(X …)``, ``find_path(X …)``."""
    first = rf"\b(?!(?:if|elseif|while|message)\b)[A-Za-z]\w*[ \t]*\([ \t]*{name}\b"
    return name in text and bool(re.search(rf"{first}|_VARIABLE[ \t]+{name}\b", text))
