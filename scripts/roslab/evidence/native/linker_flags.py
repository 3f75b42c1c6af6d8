"""Libraries that variables of CMake name as the linker does, ``-lavfilter``: what links such a variable needs them.

A find module of the tree (``FindNAME.cmake``) that looks for nothing, and sets its library variable so, is as good as
a call of target_link_libraries to whoever has the libraries.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.dependency import Dependency, Strength
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MOST = 60
"""Most words of a call, and most libraries of one find module, that are read."""
ROLE = "flag"
_FLAG = pattern(r"(?<![^\s\"'])-l([A-Za-z_][\w.+-]*)(?![^\s\"'])")
_SETS = frozenset({"set", "list"})


def named(call: Call, path: str) -> Iterator[Dependency]:
    """Yield the libraries that a ``set`` gives a variable; under a condition they may not be needed."""
    for word in call.words[1:MOST]:
        for match in _FLAG.finditer(word) if "-l" in word else ():
            strength: Strength = "optional" if call.conditions or call.in_function else "used"
            yield Dependency(namespace="link", name=match[1], strength=strength, file=path, line=call.line, role=ROLE)


def of_module(call: Call, repository: Repository, file: File) -> Iterator[Dependency]:
    """Yield those that the tree's own module for what ``find_package`` asks for gives its variables."""
    module = module_of(call, repository, file)
    if module is None:
        return
    text = repository.read(module)
    found: list[Dependency] = []
    for inner in calls(text, _SETS) if "-l" in text else ():
        if len(found) < MOST:
            found += named(replace(inner, conditions=(*call.conditions, *inner.conditions)), module.path)
    yield from found


def module_of(call: Call, repository: Repository, file: File) -> File | None:
    """Return the tree's own module for what ``find_package`` asks for, the nearest to a file of CMake."""
    name = f"Find{call.words[0]}.cmake" if call.words else ""
    found = [each for each in repository.named(name) if each.name == name and each.size <= MAX_SIZE] if name else []
    beside = [each for each in found if each.path.startswith(f"{file.folder}/")] if file.folder else []
    return next(iter(nearest(beside or found)), None)
