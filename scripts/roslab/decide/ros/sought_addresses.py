"""The repositories in which packages that nothing brings most likely are: those that pages link to, and the owner's."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet

from roslab.decide.ros.controllers import controllers
from roslab.decide.ros.sought_links import linked_by_pages
from roslab.decide.ros.source_names import OF_MESSAGES, address, plain
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.knowledge.compiled import public_hosts
from roslab.knowledge.released import ever_released
from roslab.knowledge.vendor_packages import vendor_of
from roslab.values.pattern import pattern

_OWNER = pattern(r"(https://([\w.-]+)/[\w.-]+)/[\w.-]+?/?$")
_PARTS = (*OF_MESSAGES, "_lib", "_ros", "_py", "py")
"""Ends of the names of packages that often lie beside others, in a repository called without them."""
_SHORTEST = 3
"""Fewest letters of such a name."""


def addresses_of(
    asked: Mapping[str, Dependency], evidence: Evidence, known: AbstractSet[str]
) -> list[tuple[str, tuple[str, ...]]]:
    """Return the addresses of repositories that may hold packages, most likely first, each with those packages.

    First those that pages at the root link to; then those that the code names which are called like the package, or
    with whose name it begins; then those of the same owner with the name of the package, or with that of what it is a
    part of, unless others are known to publish it or it is the name of a controller. Not what is ``known``. Last those
    of the same owner that are called by its first words, even where others publish that: it may be a copy with more.
    """
    names = tuple(asked)
    if not names:
        return []
    here = address(evidence.origin) if evidence.origin else ""
    found = {https(git.url).removesuffix(".git"): names for git in linked_by_pages(evidence, here, known, names)}
    for git in evidence.commented:
        held = tuple(name for name in names if f"{plain(name)}_".startswith(f"{plain(git.name)}_"))
        if held and address(git.url) != here and known.isdisjoint((git.name, plain(git.name))):
            found.setdefault(git.url, held)
    owner = public_owner(evidence)
    owned: dict[str, tuple[str, ...]] = {}
    ours = controllers((each for each in asked.values() if each.namespace == "rosdep"), evidence)
    free = [name for name in names if owner and name not in ours and not ever_released(name)]
    for name in free:
        for called in () if vendor_of(name)[0] else called_by(name):
            if called == name or not (called in known or ever_released(called)):
                for url in (f"{owner}/{each}" for each in _spelled(called, here)):
                    owned[url] = (*owned.get(url, ()), name)
    for name in free:
        for url in (f"{owner}/{each}" for called in wholes(name) for each in _spelled(called, here)):
            owned[url] = tuple(dict.fromkeys((*owned.get(url, ()), name)))
    there = {here, *map(address, found)}
    found |= {url: held for url, held in owned.items() if address(url) not in there}
    return list(found.items())


def by_authors(names: Iterable[str], evidence: Evidence) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield the addresses that packages have with those from whom pages clone the repository, each with its package.

    Where that is not its owner, it is a copy, and what belongs to it is still where it was. Of an author's accounts on
    several hosts those count from which pages clone. Not what others published.
    """
    pages = [git for git in evidence.sources if git.kind == "clone" and git.strength == "prose" and not git.aside]
    here = plain(address(evidence.origin or ""))
    owner = public_owner(evidence)
    authors = {_account(git) for git in pages if here and plain(git.name) == here} - {owner.rpartition("/")[2].lower()}
    accounts = dict.fromkeys(owner_of(git.url) for git in pages if _account(git) in authors)
    for name in (each for each in names if not (ever_released(each) or vendor_of(each)[0])):
        for account in filter(None, accounts):
            yield f"{account}/{name}", (name,)


def _spelled(name: str, here: str) -> tuple[str, ...]:
    """Return the names that a repository may have, with dashes first where the owner writes this one with dashes."""
    own = here.rpartition("/")[2]
    return tuple(dict.fromkeys((name.replace("_", "-"), name))) if "-" in own and "_" not in own else (name,)


def _account(git: GitSource) -> str:
    return address(git.url).rpartition("/")[0].rpartition("/")[2]


def public_owner(evidence: Evidence) -> str:
    """Return the address of the repository's owner where it lies on a host that anybody reads, else ``""``."""
    return owner_of(evidence.origin or "")


def owner_of(url: str) -> str:
    """Return the address of the owner of a repository on a host that anybody reads, ``""`` for another."""
    match = _OWNER.match(https(url))
    return match[1] if match and match[2] in public_hosts() else ""


def called_by(name: str) -> tuple[str, ...]:
    """Return the names that a repository with a package most likely has."""
    stem = next((name.removesuffix(part) for part in _PARTS if name.endswith(part)), "")
    return (name, stem) if len(stem) >= _SHORTEST else (name,)


def wholes(name: str) -> Iterator[str]:
    """Yield the beginnings of a name that have two words or more, the longest first: ``a_b`` of ``a_b_c``."""
    words = name.split("_")
    yield from ("_".join(words[:count]) for count in range(len(words) - 1, 1, -1))
