"""What a target of a plain CMake project cannot be built without: the targets that it links or waits for."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from roslab.evidence.lex.cmake import PROJECT, calls

_LINKS = frozenset({"target_link_libraries", "add_dependencies"})
_ALIAS = "ALIAS"
_READ = _LINKS | {"link_libraries", "add_library", "project"}
_EVERY = ""
"""Stands for all targets, in ``link_libraries``."""


def linked(target: str, files: Iterable[str], read: Callable[[str], str]) -> frozenset[str]:
    """Return a target and what it links or waits for in turn, by the names that CMake's files write.

    ``files`` are all of them, ``read`` returns the text of one. What another file sets a variable to stays unknown.
    """
    uses: dict[str, set[str]] = {}
    name: tuple[str, ...] = ()
    for file in sorted(files, key=lambda each: (each.count("/"), each)):
        for call in calls(read(file), _READ, variables={PROJECT: name} if name else {}):
            first, words = call.words[:1], call.words[1:]
            if call.name == "project":
                name = name or first
            elif call.name == "add_library":
                if words[:1] == (_ALIAS,) and first:
                    uses.setdefault(first[0], set()).update(words[1:2])
            elif call.name == "link_libraries":
                uses.setdefault(_EVERY, set()).update(call.words)
            elif first:
                uses.setdefault(first[0], set()).update(words)
    found = {target, *uses.get(_EVERY, ())}
    pending = [*found]
    for each in pending:
        new = uses.get(each, set()) - found
        found |= new
        pending += new
    return frozenset(found)
