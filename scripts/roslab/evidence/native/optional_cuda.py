"""Whether build files leave CUDA out: an option that is off, and that nobody is told to set, stands before it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from roslab.evidence import places
from roslab.evidence.lex.cmake import Call
from roslab.evidence.lex.truth import cmake_holds
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_FILES = 60
MAX_SIZE = 64 * 1024
_CONFIGURES = pattern(
    r"^.*\b(?:cmake[ \t]+[-.\"$/]|catkin_make\b|(?:catkin|colcon)[ \t]+(?:build|config)\b).*", re.MULTILINE
)
_TURNED_ON = pattern(r"-D[ \t]*(\w+)(?::(?:BOOL)?)?=[\"']?(?:ON|TRUE|YES|1)\b", re.IGNORECASE)
_DECLARED = pattern(r"(^|\()OFF (?=\w)")
"""How ``lex.cmake`` writes the condition of an option that is off."""


def brings(found: Iterable[Call], options: Mapping[str, bool], repository: Repository) -> bool:
    """Tell whether one of the calls that bring CUDA may take effect; ``options``: whether each declared one is on."""

    def unset(name: str) -> bool:
        return options.get(name) is False and name not in repository.once(_turned_on)

    def left_out(condition: str) -> bool:
        return cmake_holds(_DECLARED.sub(r"\1", condition), unset) is False

    return any(not any(map(left_out, call.conditions)) for call in found)


def _turned_on(repository: Repository) -> frozenset[str]:
    """Return the options that the first call of a page, a script or a Dockerfile gives CMake."""
    named = (name for name in repository.by_name if name.lower().startswith(("dockerfile", "readme")))
    files = (*repository.named(*named), *repository.suffixed(".md", ".rst", ".sh", ".dockerfile"))
    kept = {file for file in files if file.size <= MAX_SIZE and not places.vendored(file.path)}
    found: set[str] = set()
    for file in nearest(kept)[:MAX_FILES]:
        text = repository.read(file)
        if "-D" in text and (first := _CONFIGURES.search(text.replace("\\\n", " "))):
            found.update(_TURNED_ON.findall(first[0]))
    return frozenset(found)
