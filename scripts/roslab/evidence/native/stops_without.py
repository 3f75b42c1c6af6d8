"""Programs that stop where CMake did not find a library: ``throw std::runtime_error("tensorrt not installed")``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Mention
from roslab.evidence.native import torch_on_gpu
from roslab.knowledge.nvidia_libraries import nvidia_libraries
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_THROWN = pattern(r"\bthrow\s+[\w:]+\(\s*\"([^\"\n]{1,160})\"")
_LACKS = pattern(r"\b(?:not|without|no|missing|requires?|needs?)\b", re.IGNORECASE)
_SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".h")


def read(repository: Repository, projects: Iterable[CMakeProject]) -> Iterator[Mention]:
    """Yield the first place where code says so of each such library that a project looks for, or moves to a GPU."""
    projects = tuple(projects)
    yield from torch_on_gpu.read(repository, projects)
    asked = {d.name for p in projects if not places.aside(p.file) for d in p.dependencies if d.namespace == "cmake"}
    for name in sorted(asked & nvidia_libraries()):
        for file in repository.suffixed(*_SUFFIXES):
            text = "" if places.aside(file.path) else repository.read(file)
            thrown = _THROWN.finditer(text) if name.lower() in text.lower() else ()
            said = next((m for m in thrown if name.lower() in m[1].lower() and _LACKS.search(m[1])), None)
            if said:
                line = text.count("\n", 0, said.start()) + 1
                yield Mention(topic="stops", value=name, source="code", file=file.path, line=line, text=said[1])
                break
