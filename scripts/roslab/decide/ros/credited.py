"""Where a missing package most likely is: submodules that are not checked out come before guesses."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from collections.abc import Set as AbstractSet

from roslab.decide.ros.source_names import itself_in, plain, telling_words
from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence

_FEWEST_LETTERS = 5
"""Fewest letters of the two words with which the names of a family begin: ``kr_mav_msgs`` and ``kr_mav_control``."""
_FEWEST_ALIKE = 3
"""Fewest packages of the tree that begin with a word for it to be the name of all that the author has."""


def credited(name: str, evidence: Evidence) -> str:
    """Return the path of the submodule that is not checked out and most likely has a package, ``""`` without one.

    A word with which many packages of the tree begin tells nothing: ``acme_msgs`` is hardly in ``acme_models``.
    """
    absent = [git for git in evidence.sources if git.kind == "submodule" and git.absent]
    if not absent:
        return ""
    exact = (git for git in absent if plain(git.name) == plain(name))
    firsts = Counter(plain(manifest.name).partition("_")[0] for manifest in evidence.manifests if manifest.name)
    common = {word for word, count in firsts.items() if count >= _FEWEST_ALIKE}
    alike = (git for git in absent if _of_family(name, git.name, common))
    found = next(exact, None) or next(alike, None)
    return found.name if found else ""


def told_by_pages(
    found: Iterable[GitSource], evidence: Evidence, itself: set[str], own: frozenset[str]
) -> list[GitSource]:
    """Return the clones in which packages may be looked for.

    Not what is the repository itself, what not everybody needs, nor what a page below the root that has its name for a
    title clones: the page came with code from there, and says nothing of this repository.
    """
    folders = {plain(manifest.file.rpartition("/")[0]) for manifest in evidence.manifests} - {""}
    clones = [git for git in found if git.kind == "clone" and not git.aside]
    clones = [git for git in clones if not (itself_in(git, itself) or plain(git.name) in own | folders)]
    return [git for git in clones if not (git.itself and "/" in git.file and not places.documentation(git.file))]


def _of_family(name: str, other: str, common: AbstractSet[str]) -> bool:
    """Tell whether two names share a telling word that is not ``common``, or begin with the same two words."""
    start, begins = ("_".join(plain(each).split("_")[:2]) for each in (name, other))
    family = start == begins and "_" in start and len(start) > _FEWEST_LETTERS
    return family or bool((telling_words(name) & telling_words(other)) - common)
