"""Releases of libraries that a page compiles, where the code does not compile with a newer one."""

from __future__ import annotations

from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.recipes import releases
from roslab.values.version import InvalidVersion, Version


def built_older(limit: CodeLimit, evidence: Evidence) -> bool:
    """Tell whether a page compiles and installs an older release than the code refuses, and a recipe has one, too."""
    name = limit.library.lower()
    if limit.below is None or not releases(name):
        return False
    end = Version(limit.below)
    older = any(Version(release) < end for release in releases(name))
    return older and any(_older(git, end) for git in evidence.sources if git.installed and _named(git, name))


def _named(git: GitSource, name: str) -> bool:
    return git.name.lower() in {name, f"{name}-solver", f"lib{name}"}


def _older(git: GitSource, end: Version) -> bool:
    try:
        return Version((git.ref or "").removeprefix("v")) < end
    except InvalidVersion:
        return False
