"""Libraries that CMake looks for, or links, by their names and stops without, where nothing in the image has them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

from roslab.config.model import BuildTool
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.needs import code_needs
from roslab.decide.system.required import similar
from roslab.decide.system.shown_headers import headers_by_name, shown_by
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.native.searched import SEARCHED
from roslab.knowledge.shared_objects import given

SHORTEST = 4
"""Fewest letters by which the first word of a name tells what brings it: ``boost_python38``."""
_BY_HAND = ("_lib", "_library")
"""How a library's name ends that somebody's own CMake makes: no package has one of such a name."""


def not_found(
    evidence: Evidence,
    packages: Packages,
    target: Target,
    names: Collection[str],
    build_tool: BuildTool,
    *,
    built: Collection[str],
    tried: Collection[str] = (),
) -> Iterator[tuple[str, Warning_]]:
    """Yield the file that asks for each such library, with a warning.

    ``names``: those of all that is installed, built or cloned. A clone that is not ``built`` has no library to link;
    what CMake fetches by itself has one. Of a library that is looked for as a package, those ``tried``, others tell.
    """
    cloned = {plain(git.name) for git in evidence.sources if git.kind in {"clone", "inside"}}
    compiled = {name for name in names if name not in cloned or name in built}
    folders = [manifest.file.rpartition("/")[0] for manifest in packages.built]
    made = {name for project in evidence.cmake for name in project.made}
    fetched = {plain(name) for project in evidence.cmake for name in project.brought}
    told: set[str] = set()
    headers = headers_by_name(evidence) if evidence.cmake else {}
    for asked in code_needs(evidence, packages):
        if asked.name in told or asked.name in made or asked.name in tried or plain(asked.name) in fetched:
            continue
        looked = asked.role == SEARCHED
        shown = shown_by(asked, headers) if not looked else ""
        if not (looked or shown):
            continue
        of_build = not places.aside(asked.file) and (not folders or any(_below(asked.file, each) for each in folders))
        if not of_build or (given(f"lib{asked.name}.so") and not (shown and plain(asked.name) in cloned)):
            continue
        own = asked.name.partition("/")[0].lower() if asked.namespace == "include" else asked.name.lower()
        word = re.split(r"[^a-z]", own, maxsplit=1)[0]
        there = names if looked else compiled
        alike = len(word) >= SHORTEST and not asked.name.lower().endswith(_BY_HAND) and similar(word, there)
        alike = alike or any(plain(each.rpartition("/")[2]) in built for each in asked.below)
        alike = alike or similar(_joined(own), map(_joined, there))
        if not (alike or similar(own, there) or resolve(asked, target).known):
            told.add(asked.name)
            why = "which find_library looks for and" if looked else f"of which the code includes {shown}, and which"
            what = f"CMake links {asked.name}, {why} nothing is known to bring"
            if asked.namespace == "include":
                what = f"CMake looks for the header {asked.name} and stops without it, and nothing is known to bring it"
            then = "install it under `custom` or give its repository under `source` in roslab.yaml"
            yield asked.file, warn(f"{what}: {_tool(build_tool)} will stop there; {then}", asked)


def _joined(name: str) -> str:
    """Return a name without what separates its words: ``KimeraRPGO`` lies in ``Kimera-RPGO``."""
    return re.sub(r"[-_.]", "", name)


def _tool(build_tool: BuildTool) -> str:
    return "the build" if build_tool == "none" else build_tool


def _below(path: str, folder: str) -> bool:
    return not folder or path.startswith(f"{folder}/")
