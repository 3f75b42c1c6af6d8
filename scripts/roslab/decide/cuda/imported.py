"""Frameworks that the code only imports, by an API that newer releases lack: their old wheels load the CUDA of then."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.pins import Pin
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework_on_cuda
from roslab.values.requirement_line import stated

_LOADING = "tensorflow"
"""Its wheels look for the libraries of one CUDA on the system; those of torch bring their own."""


def imported(evidence: Evidence, pins: tuple[Pin, ...]) -> Iterator[Pin]:
    """Yield such a framework, as a line of a page does without a version.

    None where anything names a framework, which is then what the tree is for, nor of one program beside packages of
    ROS, whose image has the Python packages of the system.
    """
    if evidence.manifests or any(framework_on_cuda(pin.name) for pin in pins):
        return
    for use in evidence.bounds:
        if framework_on_cuda(use.bound.key) == _LOADING and not places.aside(use.file):
            yield Pin(stated(use.bound.key, "import", use.file, use.line), 1)
