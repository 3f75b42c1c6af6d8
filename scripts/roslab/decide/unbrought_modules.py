"""A module that a command imports at its top and that an author's Dockerfile does not install."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.config.model import Config, Kind
from roslab.decide.author_command import started
from roslab.decide.command import decide_command
from roslab.decide.python.manifests import with_includes
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.knowledge.often_brought import often_brought
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement

_PLAIN = (
    *("python:", "debian:", "ubuntu:", "nvidia/cuda:", "nvidia/cudagl:"),
    *("pytorch/pytorch:", "tensorflow/tensorflow:"),
)
"""Images whose Python has what their names say, and what that brings."""


def unbrought(authored: AuthorDockerfile, evidence: Evidence, config: Config, kind: Kind) -> str | None:
    """Return why a container stops at the first lines of what a page runs: the module, and the line that imports it.

    ``None`` where the Dockerfile's base or its steps may have what nobody reads, where anything that it installs is
    known to bring the package, and where so many others bring it that one of them may.
    """
    bases = [name for name, _ in authored.bases] or [authored.base or ""]
    if authored.hides or authored.taken or not all(each.startswith(_PLAIN) for each in bases):
        return None
    if kind not in {"python", "cuda"} or started(authored) or config.command is not None:
        return None
    asked = _installed(authored, evidence)
    command = decide_command(evidence, config, kind, authored.file).answer.page
    if asked is None or command is None:
        return None
    names = {each.key for each in asked} | {canonicalize_name(p.name) for p in evidence.python if p.name}
    names |= {canonicalize_name(git.name.rpartition("/")[2]) for git in (*authored.clones, *evidence.sources)}
    system = {each.name.rpartition("python3-")[2] for each in authored.dependencies}
    outside = {each.name for each in evidence.code if each.namespace == "import"} & imports().keys()
    for said in evidence.mentions:
        if said.topic != "at_top" or said.file not in command.argv or said.value not in outside:
            continue
        package, apt = imports()[said.value]
        name = canonicalize_name(package)
        alike = any(same_module(name, other) for other in (*names, *often_brought()))
        by_apt = {canonicalize_name(said.value), name, (apt or "").removeprefix("python3-")} & system
        if not (name in names or name in often_brought() or alike or by_apt):
            return f"it installs no {package}, which {said.file}:{said.line} imports, and that is what would be started"
    return None


def _installed(authored: AuthorDockerfile, evidence: Evidence) -> list[Requirement] | None:
    """Return what it asks pip for, with the files and the tree's projects in that; ``None`` if one is not read."""
    found: list[Requirement] = []
    for each in authored.requirements:
        if each.role == "file":
            name = posixpath.basename(each.written)
            files = [file for file in evidence.requirements if posixpath.basename(file.file) == name]
            if not files:
                return None
            found += [asked for file in with_includes(evidence, files) for asked in file.requirements]
        elif each.role == "project":
            found += _of_projects(evidence)
        else:
            found.append(each)
    return found


def _of_projects(evidence: Evidence) -> Iterator[Requirement]:
    for project in evidence.python:
        yield from (*project.requirements, *project.build_requires, *project.groups)
