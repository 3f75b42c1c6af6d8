"""The repository of a package that the index of pip does not have: one of its name that a page links to or clones."""

from __future__ import annotations

from roslab.decide.python.of_owner import known_of_index
from roslab.decide.ros.source_names import address, for_pip
from roslab.evidence.dependency import GitSource
from roslab.explain.answer import Explanation
from roslab.repair.change import Given, Worked
from roslab.repair.clones import surely
from roslab.values.name import canonicalize_name


def linked(found: Explanation, given: Given) -> Worked:
    """Take the package from there; surely where the page has its reader install it, or the owner is the same.

    Not one of which a table knows that the index has it: its releases are for other Pythons, and git brings no others.
    """
    names = dict(found.names)
    name, here = names.get("name", ""), address(given.evidence.origin or "")
    key = canonicalize_name(name)
    if names.get("version") or known_of_index(key):
        return Worked(why=found.fix)
    called = (git for git in given.evidence.sources if canonicalize_name(git.name) == key)
    git = next((git for git in called if _offered(git) and address(git.url) != here), None)
    if git is None:
        return Worked(why=found.fix)
    return Worked(values=(f"{name} @ {for_pip(git)}",), certain=surely(git, given))


def _offered(git: GitSource) -> bool:
    return git.kind in {"link", "clone"} and not (git.private or git.doubt)
