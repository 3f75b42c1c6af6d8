"""Packages from git whose own lists no pip satisfies any more: without those, and with what their modules import."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence, Set
from functools import cache

from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.knowledge.guesses import same_module
from roslab.knowledge.not_on_index import NotOnIndex, not_on_index
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated

_NAME = pattern(r"/([\w.-]+?)(?:\.git)?/?(?:@[^/#]*)?(?:#.*)?$")
"""The last part of an address, before a ref and a folder."""


def bare(asked: Requirement) -> NotOnIndex | None:
    """Return the row of what is installed without what it asks for itself, ``None`` for all others.

    A page may name its repository by another name than the package's, or at another owner's.
    """
    if asked.url and not asked.vcs:
        return None
    return _rows().get(_repository(asked.url) if asked.url else asked.key)


def without_list(asked: Requirement) -> Warning_:
    """Return the warning about what a manifest takes from git and that is installed without its own list."""
    row = bare(asked)
    why = f"{row.why} ({row.source})" if row else ""
    return warn(f"what {asked.written} asks for itself is not installed: {why}", asked)


def repository_of(name: str) -> str | None:
    """Return what the repository of such a package is called, under which a page may install it."""
    row = _rows().get(name)
    return _repository(row.instead) if row else None


def needs_of(asked: Iterable[Requirement], known: Set[str]) -> Iterator[Requirement]:
    """Yield what the modules of such packages import and nothing names, with the place of what needs it."""
    named = {*known}
    for each in asked:
        row = bare(each)
        for need in row.needs if row else ():
            key = canonicalize_name(need)
            if key not in named and not any(same_module(key, other) for other in named):
                named.add(key)
                yield stated(need, each.origin, each.file, each.line)


def bare_apart(
    declared: Sequence[Requirement], guessed: tuple[Requirement, ...]
) -> tuple[list[Requirement], tuple[Requirement, ...]]:
    """Move what manifests declare of these to what is installed one by one: one call of pip takes all lists or none.

    What they need is declared in their place.
    """
    moved = tuple(each for each in declared if bare(each))
    kept = [each for each in declared if each not in moved]
    return [*kept, *needs_of(moved, {each.key for each in (*kept, *guessed)})], (*moved, *guessed)


@cache
def _rows() -> dict[str, NotOnIndex]:
    """Return the rows with such needs by the names of the packages and of their repositories."""
    with_needs = {name: row for name, row in not_on_index().items() if row.needs}
    return {_repository(row.instead): row for row in with_needs.values()} | with_needs


def _repository(url: str) -> str:
    """Return the name of the repository in an address of git."""
    match = _NAME.search(url)
    return canonicalize_name(match[1]) if match else ""
