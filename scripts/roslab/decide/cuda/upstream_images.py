"""Dockerfiles that a fork has kept from the project which it began with."""

from __future__ import annotations

from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.guesses import same_module
from roslab.values.name import canonicalize_name


def of_upstream(evidence: Evidence, authored: AuthorDockerfile) -> bool:
    """Tell whether a Dockerfile clones what the tree's own project began as, and copies nothing of the tree.

    It says what that project needed: what a page of the tree says counts more.
    """
    if authored.copies_repository or authored.clones_itself:
        return False
    own = {canonicalize_name(project.name) for project in evidence.python if project.name and not project.folder}
    cloned = {canonicalize_name(git.name.rpartition("/")[2]) for git in authored.clones}
    return any(name in own or same_module(name, other) for name in cloned for other in own)
