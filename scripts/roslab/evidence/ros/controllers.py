"""Controllers that parameter files start, whose types are called after another package than theirs."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.lines import matching_lines
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 800
"""Most files that are opened, those nearest to the root first."""
_TYPE = pattern(r"[^#\n]{0,99}\btype\"?[ \t]*:[ \t]*[\"']?(\w{1,60}/\w{1,60})")
_NAMED = pattern(
    r"(?m)^([ \t]*)(\w{1,60}):[ \t]*(?:#[^\n]*)?\n\1[ \t]+type\"?[ \t]*:[ \t]*"
    r"[\"']?(\w{1,60}_(?:controllers?|broadcaster))/\w"
)
"""A controller's name with the line of its type below it."""
_OF_ROS2 = "ros__parameters"


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of these controllers, each once, where it is named first, and all controllers by name."""
    files = [f for f in repository.suffixed(".yaml", ".yml") if f.size <= MAX_SIZE and not places.vendored(f.path)]
    found: dict[str, Dependency] = {}
    named: dict[str, Dependency] = {}
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for match in matching_lines(_TYPE, text, "_controllers/"):
            from roslab.knowledge.controller_types import controller_package  # noqa: PLC0415 - few trees have controllers

            name = controller_package(match[1], 2 if _OF_ROS2 in text else 1)
            if name and name not in found:
                line = text.count("\n", 0, match.start(1)) + 1
                found[name] = Dependency(
                    namespace="ros", name=name, strength="used", file=file.path, line=line, role="exec"
                )
        for match in _NAMED.finditer(text) if "type" in text else ():
            line = text.count("\n", 0, match.start(2)) + 1
            controller = Dependency(
                namespace="controller", name=match[2], strength="used", file=file.path, line=line, role=match[3]
            )
            named.setdefault(match[2], controller)
    return (*found.values(), *named.values())
