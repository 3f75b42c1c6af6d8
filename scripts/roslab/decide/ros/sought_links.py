"""The repositories that pages at the root link to, in which the build may look for packages that nothing brings."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.decide.ros.source_names import address, akin, plain
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.libraries import library
from roslab.values.name import bare_name

_MOST_LISTED = 4
"""Most of them that a page lists among what is needed."""
_MOST_BESIDE = 5
"""Most of them that stand in a section about other packages."""


def linked_by_pages(
    evidence: Evidence, here: str, known: AbstractSet[str], names: Collection[str]
) -> Iterator[GitSource]:
    """Yield the repositories of the same owner that pages at the root link to; of others, the only one that they do.

    Before all, the first of those of anybody that a page says to hold the dependencies, or lists among them. After all,
    the first of those in a section about other packages, the ones that are called like a missing one before others.
    Not one with the name of what is known, as of one of the repository's own packages, which is what it was made from;
    nor one with the repository's own name, which is itself under another owner.
    """
    first = listed_by_pages(evidence, here, known, names)
    yield from first
    owner = here.rpartition("/")[0]
    others = _others(evidence, here, known)
    near = [git for url, git in others.items() if len(others) == 1 or (owner and url.rpartition("/")[0] == owner)]
    near = [git for git in near if git not in first]
    yield from near
    of_ros = _of_ros(others.values(), evidence, names)
    beside = [git for git in of_ros if git.of_packages and not git.private and git not in (*first, *near)]
    yield from sorted(beside, key=lambda git: not any(akin(name, git.name) for name in names))[:_MOST_BESIDE]


def listed_by_pages(evidence: Evidence, here: str, known: AbstractSet[str], names: Collection[str]) -> list[GitSource]:
    """Return the first repositories that pages at the root say to hold the dependencies, or list among them."""
    listed = _of_ros(_others(evidence, here, known).values(), evidence, names)
    return [git for git in listed if git.holds][:_MOST_LISTED]


def _others(evidence: Evidence, here: str, known: AbstractSet[str]) -> dict[str, GitSource]:
    """Return what pages at the root link to, by its address, without what is known or the repository itself.

    Nor what a page compiles with CMake or make and installs, outside of any workspace: that holds no package of ROS.
    """
    itself = here.rpartition("/")[2]
    clones = (git for git in evidence.sources if git.kind == "clone" and git.installed)
    by_hand = {address(git.url) for git in clones if git.configured or git.by_make}
    links = (git for git in evidence.sources if git.kind == "link" and "/" not in git.file)
    return {
        address(git.url): git
        for git in links
        if known.isdisjoint((git.name, plain(git.name))) and address(git.url) not in {here, *by_hand}
        if not itself or plain(git.name) != plain(itself)
    }


def _of_ros(links: Iterable[GitSource], evidence: Evidence, names: Collection[str]) -> list[GitSource]:
    """Return the repositories that may hold packages of ROS: no project of Python, nor what Ubuntu has."""
    of_python = {bare_name(name) for name in _of_python(evidence)}
    of_ros = (git for git in links if bare_name(git.name) not in of_python)
    return [git for git in of_ros if not of_ubuntu(git) and not _of_import(git, names)]


def _of_python(evidence: Evidence) -> Iterator[str]:
    """Yield the names that projects and lists for pip declare."""
    lists = (*(each.requirements for each in evidence.python), *(each.requirements for each in evidence.requirements))
    yield from (asked.name for each in lists for asked in each if asked.name)


def _of_import(git: GitSource, names: Iterable[str]) -> bool:
    """Tell whether a repository is called like a module that pip brings, and like none of the packages."""
    return plain(git.name) in imports() and not any(akin(name, git.name) for name in names)


def of_ubuntu(git: GitSource) -> bool:
    """Tell whether Ubuntu has what a repository is called like."""
    return bool((known := library("cmake", git.name, None)) and known.apt)
