"""A module that a command imports at its top and that an author's Dockerfile does not install."""

from __future__ import annotations

import posixpath

from roslab.config.model import Config, Kind
from roslab.decide.author_command import started
from roslab.decide.command import decide_command
from roslab.decide.python.manifests import with_includes
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.knowledge.often_brought import all_brought, often_brought
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

_PLAIN = ("python:", "debian:", "ubuntu:", "nvidia/cuda:", "nvidia/cudagl:")
"""Images whose Python has nothing but what installs packages."""
_OF_PYTHON = pattern(
    r"(?:lib)?python[\d.]*(?:-(?:dev|venv|distutils|minimal|full|pip|setuptools|wheel|apt|is-python3))*"
)
"""Packages of apt that are Python itself, or that install packages."""


def unbrought(authored: AuthorDockerfile, evidence: Evidence, config: Config, kind: Kind) -> str | None:
    """Return why a container stops at the first lines of what a page runs: the module, and the line that imports it.

    ``None`` where the Dockerfile's base or its steps may have what nobody reads, where it installs anything of which a
    table does not say all that it brings, and where so many others bring the package that one of them may.
    """
    bases = [name for name, _ in authored.bases] or [authored.base or ""]
    if authored.hides or authored.taken or authored.clones or not all(each.startswith(_PLAIN) for each in bases):
        return None
    if kind not in {"python", "cuda"} or started(authored) or config.command is not None:
        return None
    asked = _installed(authored, evidence)
    command = decide_command(evidence, config, kind, authored.file).answer.page
    if asked is None or command is None:
        return None
    system = {each.name.removeprefix("python3-") for each in authored.dependencies if _has_modules(each.name)}
    names = {each.key for each in asked} | system
    if names - all_brought().keys():
        return None
    names |= {brought for name in names for brought in all_brought()[name]}
    names |= {canonicalize_name(p.name) for p in evidence.python if p.name}
    names |= {canonicalize_name(git.name.rpartition("/")[2]) for git in evidence.sources}
    outside = {each.name for each in evidence.code if each.namespace == "import"} & imports().keys()
    for said in evidence.mentions:
        if said.topic != "at_top" or said.file not in command.argv or said.value not in outside:
            continue
        package, _ = imports()[said.value]
        name = canonicalize_name(package)
        alike = any(same_module(name, other) for other in (*names, *often_brought()))
        if not (name in names or name in often_brought() or alike):
            return f"it installs no {package}, which {said.file}:{said.line} imports, and that is what would be started"
    return None


def _has_modules(apt: str) -> bool:
    """Tell whether a package of apt may bring modules of Python."""
    return apt.startswith(("python", "ipython", "jupyter", "ros-")) and not _OF_PYTHON.fullmatch(apt)


def _installed(authored: AuthorDockerfile, evidence: Evidence) -> list[Requirement] | None:
    """Return what it asks pip for, with the files and the tree's project in that; ``None`` if it may ask for more."""
    found: list[Requirement] = []
    for each in authored.requirements:
        if each.role == "file":
            name = posixpath.basename(each.written)
            files = [file for file in evidence.requirements if posixpath.basename(file.file) == name]
            if not files or "://" in each.written:
                return None
            found += [asked for file in with_includes(evidence, files) for asked in file.requirements]
        elif each.role == "project":
            projects = [project for project in evidence.python if project.folder == ""]
            if posixpath.normpath(each.written) != "." or not all(project.requirements for project in projects):
                return None
            found += [asked for p in projects for asked in (*p.requirements, *p.build_requires, *p.groups)]
        else:
            found.append(each)
    found = [each for each in found if each.role != "option"]
    return None if any(each.extras or each.url or not each.package or not each.name for each in found) else found
