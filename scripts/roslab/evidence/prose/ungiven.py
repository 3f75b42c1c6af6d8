"""Author's Dockerfiles that build a workspace without an option that CMake of a package demands, and so stop."""

from __future__ import annotations

import re
from collections.abc import Sequence

from roslab.evidence.lex.dockerfile import Instruction
from roslab.evidence.native.asked_definitions import definitions
from roslab.evidence.prose.built_packages import UNREAD, texts_of, tools
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_SELECTS = pattern(r"--packages|\|\||--only-pkg|--pkg\b|\bcatkin[ \t]+(?:build|make)[ \t]+\w")
"""It may build others alone, or go on all the same."""
_OF_COLCON = ("colcon.meta", "defaults.yaml", "colcon-defaults.yaml", "colcon_defaults.yaml")


def ungiven(repository: Repository, written: Sequence[Instruction]) -> str | None:
    """Return why a build of the workspace stops, ``None`` where it may not: nothing names what CMake demands."""
    packages = {file.folder for file in repository.named("package.xml")}
    demanded = [each for each in repository.once(definitions) if each.folder in packages]
    if not demanded:
        return None
    texts = texts_of(repository, written)
    if texts is None or any(map(UNREAD.search, texts)):
        return None
    if not (called := [call for text in texts for call in tools(text)]) or any(map(_SELECTS.search, (*called, *texts))):
        return None
    said = "\n".join((*texts, *(each.text for each in written), *map(repository.read, repository.named(*_OF_COLCON))))
    for each in demanded:
        if not re.search(rf"(?:\b|-D){each.name}\b", said):
            return f"it builds the workspace without -D{each.name}, without which {each.file} stops (line {each.line})"
    return None
