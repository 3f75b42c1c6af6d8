"""Calls of make on pages of a Python project whose modules of protobuf are generated: git ignores them."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import lines_of
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

DEEPEST = 1
"""A page below is about a part."""
_MAKE = pattern(r"^[ \t]{0,8}(?:\$[ \t]+)?(make(?:[ \t]+[\w.+=/-]{1,80}){0,10})[ \t]*$")
_IGNORED = pattern(r"^/?(?:[\w.*-]+/)*\*_pb2\*?(?:\.py)?\s*$")


def read(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    """Yield a step for each call of make in a block of a page, where modules of protobuf have to be generated.

    That is where the tree has ``.proto`` files and no module of them, git ignores such modules, and the root is
    neither a CMake project nor a package of ROS, whose own build would run.
    """
    if "make" not in text or file.path.count("/") > DEEPEST or not _missing(repository):
        return
    for line in lines_of(text):
        if line.fenced and (match := _MAKE.match(line.text)):
            value = " ".join(match[1].split())
            yield Mention(topic="step", value=value, source="readme", file=file.path, line=line.number, text=value)


def _missing(repository: Repository) -> bool:
    """Tell whether the tree lacks the modules that protobuf generates from its files."""
    if not repository.suffixed(".proto") or repository.has("CMakeLists.txt") or repository.named("package.xml"):
        return False
    if any(each.name.endswith("_pb2.py") for each in repository.suffixed(".py")):
        return False
    return any(_IGNORED.match(line) for each in repository.named(".gitignore") for line in _lines(repository, each))


def _lines(repository: Repository, file: File) -> list[str]:
    return repository.read(file).split("\n")
