"""Refs that are called after the reader's distribution of ROS, filled in with the one of the image."""

from __future__ import annotations

from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace

_BLANK = "{distro}"


def with_refs(evidence: Evidence, distro: str | None) -> Evidence:
    """Return the evidence with the distribution in the refs of what is cloned; without one, they name no ref."""
    blank = any(_BLANK in (git.ref or "") for git in evidence.sources)
    if not blank and not any(_BLANK in (git.ref or "") for each in evidence.dockerfiles for git in each.clones):
        return evidence
    return replace(
        evidence,
        sources=tuple(_filled(git, distro) for git in evidence.sources),
        dockerfiles=tuple(
            replace(each, clones=tuple(_filled(git, distro) for git in each.clones)) for each in evidence.dockerfiles
        ),
    )


def _filled(git: GitSource, distro: str | None) -> GitSource:
    if _BLANK not in (git.ref or ""):
        return git
    return replace(git, ref=(git.ref or "").replace(_BLANK, distro) if distro else None)
