"""What the chosen lists, projects and environment ask for, as they are written."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.python.manifests import with_includes
from roslab.decide.python.packages import Chosen
from roslab.evidence.facts import Evidence
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def own_names(evidence: Evidence) -> set[str]:
    """Return the names of the tree's own projects and of what is cloned."""
    names = {project.name for project in evidence.python} | {git.name.rpartition("/")[2] for git in evidence.sources}
    return {canonicalize_name(name) for name in names if name}


def of_manifests(evidence: Evidence, chosen: Chosen) -> list[Requirement]:
    """Return what the chosen files, projects and environment ask for."""
    found = [asked for file in with_includes(evidence, chosen.files) for asked in file.requirements]
    found += [asked for project in chosen.projects for asked in project.requirements if asked.role in {"", "source"}]
    return [*found, *chosen.declared, *of_environment(evidence, chosen)]


def of_environment(evidence: Evidence, chosen: Chosen) -> Iterator[Requirement]:
    """Yield what the chosen conda environment has for pip."""
    for environment in evidence.conda:
        if environment.file == chosen.conda:
            yield from environment.requirements
