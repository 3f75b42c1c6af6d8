"""Lists of packages that belong to a part of the tree: a baseline, say, beside the program that the root is about."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from roslab.config.model import Kind
from roslab.evidence.facts import Evidence
from roslab.knowledge.guesses import tooling, tools_of_developers

FEWEST = 2
"""Fewest packages that a page installs by name where they are all that it needs."""
_BASELINES = frozenset({"baseline", "baselines"})


def of_parts(evidence: Evidence) -> frozenset[str]:
    """Return the environments and requirement files of parts, where a page at the root installs packages by name.

    A part is a folder with programs, or a page that runs some, which no page at the root runs; a manifest at the root
    makes none a part.
    """
    files = [*(each.file for each in evidence.conda), *(each.file for each in evidence.requirements)]
    rooted = any("/" not in file for file in files) or any(not project.folder for project in evidence.python)
    tools = tooling("installers") | tools_of_developers()
    asked = (each for each in evidence.prose_pip if "/" not in each.file)
    named = {each.key for each in asked if each.name and not each.role} - tools
    if rooted or len(named) < FEWEST:
        return frozenset()
    run = set(_run_by_root(evidence))
    started = [program.file for program in evidence.programs]
    started += [mention.file for mention in evidence.mentions if mention.topic == "command"]
    programs = {file.partition("/")[0] for file in started if "/" in file}
    return frozenset(file for file in files if file.partition("/")[0] in programs - run)


def of_baselines(evidence: Evidence, kind: Kind) -> frozenset[str]:
    """Return the requirement files of what compiled code is compared with."""
    compared = in_baselines(evidence, kind)
    return frozenset(file.file for file in evidence.requirements if compared(file.file))


def in_baselines(evidence: Evidence, kind: Kind) -> Callable[[str], bool]:
    """Return what tells whether a file is of what compiled code is compared with: no page at the root runs that."""
    run = set(_run_by_root(evidence)) if kind == "cpp" else set[str]()

    def compared(path: str) -> bool:
        inside = not _BASELINES.isdisjoint(path.lower().split("/")[:-1])
        return kind == "cpp" and inside and path.partition("/")[0] not in run

    return compared


def _run_by_root(evidence: Evidence) -> Iterator[str]:
    """Yield the folders at the root in which pages there run, or install, something."""
    for mention in evidence.mentions:
        if mention.topic == "command" and "/" not in mention.file:
            yield from (path.partition("/")[0] for path in (*mention.files, *mention.value.split(), mention.inside))
    for asked in evidence.prose_pip:
        if "/" not in asked.file and asked.role in {"file", "environment", "project"}:
            yield asked.written.removeprefix("./").partition("/")[0]
