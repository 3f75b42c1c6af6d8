"""Projects of CMake that its files fill in from a template and configure on the way, and the CMake that they are for.

Such a template downloads what the project itself is built with: https://github.com/Crascit/DownloadProject.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import calls
from roslab.evidence.native import cmake_since
from roslab.evidence.native.x86 import MAX_FILES, MAX_SIZE
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

_TEMPLATE = pattern(r"(?:CMakeLists(?:\.\w+)*|.*\.cmake)\.in$")
_ASKING = frozenset({"cmake_minimum_required"})


def files(repository: Repository) -> list[File]:
    """Return the templates of CMake's files, those nearest to the root first."""
    found = (file for file in repository.suffixed(".in") if file.size <= MAX_SIZE and _TEMPLATE.match(file.name))
    return nearest(found)[:MAX_FILES]


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the version that each template says it is for."""
    for file in files(repository):
        text = repository.read(file)
        if places.sample(file.path) or "cmake_minimum_required" not in text.lower():
            continue
        for call in calls(text, _ASKING):
            if asked := cmake_since.minimum(call, file.path):
                yield Mention(
                    topic="template",
                    value=asked.version or "",
                    source="code",
                    file=file.path,
                    line=call.line,
                    text=" ".join(call.words),
                )
