"""Libraries that a package of the tree is called like: it wraps one that a page compiles and installs."""

from __future__ import annotations

from roslab.decide.ros.source_names import address, plain
from roslab.decide.system.by_everybody import headers_of, includes
from roslab.decide.system.by_hand import built_by_hand
from roslab.evidence.facts import Evidence


def wrapped(evidence: Evidence) -> frozenset[str]:
    """Return the names of the clones that are compiled by hand and of which the code includes headers not in the tree.

    None is the repository itself.
    """
    itself = address(evidence.origin) if evidence.origin else ""
    built = [git for git in built_by_hand(evidence) if git.kind == "clone" and (git.configured or git.by_make)]
    headers = headers_of(evidence) if built else {}
    return frozenset(plain(git.name) for git in built if address(git.url) != itself and includes(git, headers))
