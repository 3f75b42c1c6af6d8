"""Whether the default command opens a window."""

from __future__ import annotations

from roslab.decide.launched_windows import opened_by_nodes, switched_on
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.runners import SIMULATORS
from roslab.knowledge.windows import opens
from roslab.values.pattern import pattern

_WINDOW = pattern(r"(?:^|[/_-])(?:gui|viewer|visualizer)$")
"""What a program is called that opens a window, whatever library it does that with."""


def opens_windows(evidence: Evidence, command: str) -> bool:
    """Tell whether a launch file starts a viewer, the code uses a library of windows, or the command's file has one."""
    if command.partition(" ")[0] in SIMULATORS or _WINDOW.search(command.partition(" ")[0]):
        return True
    calls = (d for d in evidence.code if d.namespace == "call")
    words = command.split()
    if any(d.file in command or d.role == "build" or _as_module(d.file) in words or _example(d, words) for d in calls):
        return True  # a compiled program is not named like its file
    if any(launch.gui for launch in evidence.launch) or switched_on(evidence, words):
        return True
    if opened_by_nodes(evidence, tuple(words)):
        return True
    asked = (d for project in evidence.cmake if not places.vendored(project.file) for d in project.dependencies)
    found = (*evidence.code, *(d for d in asked if d.strength == "declared" and d.role != "test"))
    return any(d.strength != "optional" and opens(d.namespace, d.name) for d in found if not places.aside(d.file))


def _example(call: Dependency, words: list[str]) -> bool:
    """Tell whether a call is in the source of the example that a command starts, which is called like it."""
    stem = call.file.rpartition("/")[2].partition(".")[0]
    return call.role == "example" and any(word.rpartition("/")[2] == stem for word in words[:3])


def _as_module(file: str) -> str:
    """Return the name by which ``python -m`` starts a file."""
    return file.removesuffix(".py").removesuffix("/__main__").replace("/", ".")
