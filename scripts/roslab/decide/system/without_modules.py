"""Modules of pkg-config that CMake looks for and stops without, and that nothing is known to bring."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.built import Built
from roslab.decide.system.names import resolve
from roslab.decide.system.required import reached, similar
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence

_SHORTEST = 3
"""Fewest letters by which the first word of a name tells what brings it: ``libusb-1.0``."""


def without_modules(
    evidence: Evidence, packages: Packages, built: Built, may_hold: Callable[[str], bool]
) -> Iterator[tuple[str, Warning_]]:
    """Yield the file of each call that asks for such modules, with a warning.

    Not where the call names another one that is there, for one may be enough, nor where something that is installed,
    cloned or made in the tree is called alike. ``may_hold``: whether what is cloned may be of a name.
    """
    made = [name for project in evidence.cmake for name in (*project.made, *project.brought, project.name or "")]
    own = (*made, *packages.names, *(git.name for git in evidence.sources if git.kind not in {"link", "clone"}))
    names = {*built.names, *map(plain, own)}
    told: set[str] = set()
    for package, project in reached(evidence, packages, built.kind):
        asked = [each for each in project.dependencies if _stops(each)]
        there = {each.line for each in asked if resolve(each, built.target).known or _alike(each.name, names)}
        for each in asked:
            if each.name in told or each.line in there or package in built.out or may_hold(each.name):
                continue
            call = tuple(dict.fromkeys(other.name for other in asked if other.line == each.line))
            told.update(call)
            what = f"CMake of {package} asks pkg-config for {' and '.join(call)}, and nothing is known that brings "
            what += "it" if len(call) == 1 else "any of them"
            then = "give its package under `apt` or its repository under `source` in roslab.yaml"
            yield each.file, warn(f"{what}: {built.build_tool} will most likely stop there; {then}", each)


def _stops(asked: Dependency) -> bool:
    return asked.namespace == "pkg-config" and asked.strength == "declared" and asked.role != "test"


def _alike(name: str, names: set[str]) -> bool:
    word = re.split(r"[^a-z]", name.lower().removeprefix("lib"), maxsplit=1)[0]
    return similar(plain(name), names) or (len(word) >= _SHORTEST and similar(word, names))
