"""The releases of libraries of the table that a page names where it links to them."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.config.model import Source
from roslab.decide.ros.source_names import address
from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.recipes import release_of, tag_of
from roslab.values.dataclass import replace
from roslab.values.version import version_of


def linked_releases(evidence: Evidence) -> dict[str, GitSource]:
    """Return the links that name one release, by their address; a page at the root counts first."""
    named = [git for git in evidence.sources if git.kind == "link" and git.release and not places.vendored(git.file)]
    return {address(git.url): git for git in sorted(named, key=lambda git: git.file.count("/"), reverse=True)}


def of_release(source: Source, links: Mapping[str, GitSource]) -> GitSource | None:
    """Return the link to a library at the tag of its release, ``None`` where the table's own is the one to build.

    A newer one is what the code was written for. Of older ones that is so only of one that came before a release of the
    same number (``4.2a8`` before 4.2): its interface was not settled, and it compiles where that does.
    """
    git = links.get(address(source.repo or ""))
    if git is None or git.forked or git.doubt or git.private:
        return None
    ours, theirs = (version_of(release_of(source.name, ref)) for ref in (source.ref or "", git.release))
    if ours is None or theirs is None:
        return None
    before = theirs.is_prerelease and theirs.release[:2] == ours.release[:2]
    tag = git.ref if git.release in (git.ref or "") else tag_of(source.name, git.release)
    return replace(git, ref=tag) if tag and (theirs > ours or before) else None
