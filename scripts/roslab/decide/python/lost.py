"""Imports of the code that nothing in the image brings: each is told, with the line that imports it."""

from __future__ import annotations

from collections.abc import Iterator, Set

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.guesses import known_names
from roslab.decide.python.packages import Chosen
from roslab.decide.reasons import warn
from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.not_on_index import not_on_index
from roslab.knowledge.released import released
from roslab.values.name import bare_name, canonicalize_name
from roslab.values.requirement import Requirement

MOST = 8
"""Most modules that are named in one warning."""
SHORTEST = 4
"""Fewest letters of a beginning that two names have in common by more than chance."""


def lost(evidence: Evidence, kind: Kind, chosen: Chosen) -> Iterator[Warning_]:
    """Yield a warning for each imported module that pip's index is known to lack, and one for those of no table.

    Where a manifest declares packages, or a submodule is missing, the warning says that one of them may bring such a
    module; a module whose name begins like one of them is not told.
    """
    known = known_names(evidence, chosen.files, chosen.projects, chosen.conda) | {
        asked.key for asked in (*chosen.declared, *chosen.guessed, *_extras(evidence))
    }
    known |= {canonicalize_name(git.name.rpartition("/")[2]) for git in evidence.sources if git.kind != "link"}
    known |= {part for name in known for part in (*name.split("-"), name.replace("-", ""))}
    unknown: list[Dependency] = []
    for used in evidence.code if kind in {"cuda", "python"} else ():
        name = canonicalize_name(used.name)
        aside = places.aside(used.file)
        if used.namespace != "import" or used.strength != "used" or aside or name in known:
            continue
        row = not_on_index().get(name)
        if row and not row.instead:
            then = f"install it with `custom` or `source` in roslab.yaml ({row.source})"
            yield warn(f"the code imports {used.name}, which pip cannot install: {row.why}; {then}", used)
        elif row is None and used.name not in imports():
            unknown.append(used)
    absent = [git.name for git in evidence.sources if git.kind == "submodule" and git.absent]
    declared = bool(chosen.files or chosen.conda or chosen.declared)
    declared = declared or any(project.requirements for project in chosen.projects)
    if declared or absent:
        stems = {part for name in known for part in name.split("-")} | {bare_name(name) for name in known}
        unknown = [each for each in unknown if not _begins_like(each.name, stems)]
        ros = (released("noetic") | released("humble")) if unknown else frozenset[str]()
        unknown = [each for each in unknown if each.name not in ros]  # a part for robots, without which the rest runs
    if unknown:
        names = ", ".join(each.name for each in unknown[:MOST]) + (", …" if unknown[MOST:] else "")
        message = f"imported and declared nowhere, and no table knows which package brings it: {names}"
        others = [*(["a declared package"] if declared else []), *(["a submodule"] if absent else [])]
        unless = f"unless {' or '.join(others)} brings it, " if others else ""
        yield warn(f"{message}; {unless}name the package under `pip` in roslab.yaml if it is needed", unknown[0])


def _extras(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what the projects ask for in extras: who needs such a module knows where it comes from."""
    for project in evidence.python:
        yield from (asked for asked in project.requirements if asked.role == "extra")


def _begins_like(module: str, stems: Set[str]) -> bool:
    """Tell whether a module has the beginning of a package's name, or that of it."""
    name = bare_name(module)
    return any(len(stem) >= SHORTEST and (name.startswith(stem) or stem.startswith(name)) for stem in stems)
