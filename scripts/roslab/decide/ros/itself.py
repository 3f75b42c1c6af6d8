"""The names by which pages and lists may speak of the repository itself: as a fork or a mirror it has another one."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.ros.source_names import address, itself_in, plain
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_LIST = pattern(r"(?<![\w./~-])[\w./~-]+\.(?:repos|rosinstall)\b")
_FOLDERS = frozenset({"src", "ws", ".", "..", "~"})
"""Folders of a workspace, which no repository is called by."""


def names_of_itself(evidence: Evidence, folder_name: str, own: Collection[str]) -> set[str]:
    """Return the repository's names in lower case: its folder's, its origin's, its packages', and what pages say.

    A page gives it one where it imports a list of repositories from a clone, and the tree has that list there. Where
    none of these is cloned at the root, it is a clone named like the page, or one below the words "clone this
    repository"; not one that a manifest asks for. ``own``: its packages.
    """
    names = {folder_name, address(evidence.origin).rpartition("/")[2], *own, *_of_lists(evidence)}
    names = {name.lower() for name in names} - {"", *_FOLDERS}
    cloned = [git for git in evidence.sources if git.kind == "clone" and "/" not in git.file]
    if any(itself_in(git, names) for git in cloned):
        return names
    asked = {plain(each.name) for manifest in evidence.manifests for each in manifest.dependencies}
    return names | {git.name.lower() for git in cloned if git.itself and plain(git.name) not in asked}


def _of_lists(evidence: Evidence) -> Iterator[str]:
    """Yield the folders in which pages and scripts find lists of repositories that the tree has."""
    lists = {git.file for git in evidence.sources if git.kind == "vcs"}
    for mention in evidence.mentions if lists else ():
        if mention.topic == "vcs_file" and mention.source in {"readme", "script", "ci"}:
            for path in _LIST.findall(mention.text):
                parts = path.lstrip("./").split("/")
                yield from (parts[n - 1] for n in range(1, len(parts)) if "/".join(parts[n:]) in lists)
