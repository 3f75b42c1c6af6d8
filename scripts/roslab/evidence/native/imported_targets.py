"""Imported targets that a CMakeLists.txt links and that only later releases of their library have."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import Call
from roslab.knowledge.imported_targets import imported_target

_LINKING = "target_link_libraries"


def needs(call: Call, path: str) -> Iterator[Dependency]:
    """Yield the libraries whose targets a call always links, each with its first release that has the target."""
    if call.name != _LINKING or call.conditions or call.in_function:
        return
    for word in call.words[1:]:
        found = imported_target(word) if "::" in word else None
        if found:
            yield Dependency(
                namespace="cmake",
                name=found.package,
                strength="declared",
                file=path,
                line=call.line,
                version=found.since,
                role="test" if places.test(path) else "build",
                required=True,
                target=word,
            )


def of_others(asked: Dependency, own: Collection[str]) -> bool:
    """Tell whether a dependency is no target that the tree itself makes; ``own`` are its targets and its modules."""
    return not asked.target or (asked.target not in own and asked.name not in own)
