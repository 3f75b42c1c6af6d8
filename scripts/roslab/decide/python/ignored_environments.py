"""Conda environments of the tree that are not made: each is told, with the reason."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.conda_environments import OF_OTHER_SYSTEM
from roslab.decide.python.manifests import for_reference, resolve
from roslab.decide.python.packages import Chosen
from roslab.decide.python.parts import of_parts
from roslab.decide.python.pins import of_conda
from roslab.decide.python.unmade_environments import ORIGIN
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence


def ignored_environments(evidence: Evidence, kind: Kind, chosen: Chosen) -> Iterator[Warning_]:
    """Yield a warning for each that a page makes, and, where none is made, for each at the root."""
    known = {each.file: each for each in evidence.conda if not places.vendored(each.file) and not each.specs}
    named = {resolve(each, known) for each in evidence.prose_pip if each.role == "environment"}
    for path, environment in known.items():
        aside = places.test(path) or places.documentation(path) or bool(OF_OTHER_SYSTEM.search(path))
        if path == chosen.conda or aside or not (path in named or (chosen.conda is None and "/" not in path)):
            continue
        why = _why(environment, evidence, kind, chosen)
        yield warn(f"{path} is not made: {why}; `conda: {path}` in roslab.yaml makes it", environment)


def _why(environment: CondaEnvironment, evidence: Evidence, kind: Kind, chosen: Chosen) -> str:
    path = environment.file
    if path in for_reference(evidence):
        return "a page shows it for reference alone"
    if path in of_parts(evidence):
        return "it is for a part of the tree, and a page at the root installs what the whole needs"
    if chosen.conda:
        return f"an image has one environment, here that of {chosen.conda}"
    if kind in {"ros1", "ros2", "cpp"}:
        return "what is compiled here is for the Python of the Ubuntu"
    if chosen.files:
        return f"{chosen.files[0].file} is installed in its place"
    pinned = {each.written for each in of_conda(environment) if "=" in each.written}
    also = [
        each.written
        for each in chosen.guessed
        if (each.origin == ORIGIN and each.file == path) or each.written in pinned
    ]
    return "the project says what it needs" + (f", and pip installs {' and '.join(also)} of it" if also else "")
