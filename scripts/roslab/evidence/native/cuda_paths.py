"""Toolkits of CUDA whose folder a file of CMake names: ``/usr/local/cuda-10.2``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

FOLDER = "/usr/local/cuda-"
_PATH = pattern(r"/usr/local/cuda-(\d{1,2}\.\d)\b(?![\w.-])")
"""https://docs.nvidia.com/cuda/archive/10.2/cuda-installation-guide-linux/index.html#environment-setup, 2026-11-27"""
_LOOKED_IN = frozenset({"HINTS", "PATHS"})
"""https://cmake.org/cmake/help/latest/command/find_library.html, 2026-11-27"""
_NEVER_NEEDED = ("find_", "message")
"""Calls that look into a folder, one among others, or only tell of it."""


def read(repository: Repository) -> Iterator[Mention]:
    """Yield each version once, at the first place that names its folder; none of vendored code, examples or tests.

    What looks whether the folder is there, or searches it, needs none: made, it would be taken for the real one.
    """
    told: set[str] = set()
    for file in (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake")):
        text = "" if places.aside(file.path) else repository.read(file)
        for call in calls(text, frozenset({"*"})) if FOLDER in text else ():
            for version in _named(call):
                if version not in told:
                    told.add(version)
                    said = f"{call.name}({' '.join(call.written)})"[:120]
                    yield Mention(
                        topic="cuda_path", value=version, source="code", file=file.path, line=call.line, text=said
                    )


def _named(call: Call) -> Iterator[str]:
    """Yield the versions that a call needs."""
    if call.name.startswith(_NEVER_NEEDED) or any(FOLDER in condition for condition in call.conditions):
        return
    for word in call.written:
        if word in _LOOKED_IN:
            return
        yield from _PATH.findall(word)
