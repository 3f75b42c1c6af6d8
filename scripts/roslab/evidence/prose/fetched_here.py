"""Files that a page fetches from the repository itself, by their address at GitHub: the tree has them."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.evidence.facts import Mention
from roslab.evidence.ros.vcs import https
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_RAW = pattern(
    r"https?://(?:raw\.githubusercontent\.com/([\w.-]+/[\w.-]+)|(?:www\.)?github\.com/([\w.-]+/[\w.-]+)/raw)/"
    r"(?:refs/(?:heads|tags)/)?[^/\s]+/([^\s?#]+)"
)
"""A file of a repository at a branch: https://docs.github.com/en/repositories/working-with-files/using-files/viewing-a-file"""


def without(mentions: Iterable[Mention], repository: Repository) -> tuple[Mention, ...]:
    """Return what pages say without the steps that fetch a file which the tree has."""
    origin = https(repository.origin or "").removesuffix(".git").rstrip("/").lower()
    return tuple(m for m in mentions if m.topic != "step" or not _in_tree(m.value, origin, repository))


def _in_tree(step: str, origin: str, repository: Repository) -> bool:
    found = _RAW.search(step)
    if not found or f"https://github.com/{found[1] or found[2]}".lower() != origin:
        return False
    return repository.has(found[3])
