"""Libraries that no package of the Ubuntu contains, as sources to build."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Source
from roslab.evidence.dependency import Dependency
from roslab.knowledge.recipes import Recipe, recipe


def recipes_for(wanted: Iterable[tuple[str, Dependency]], ubuntu: str | None) -> tuple[tuple[Source, Dependency], ...]:
    """Return the sources of libraries, each once with what asked for it, in the order to build them."""
    found: dict[str, tuple[Source, Dependency]] = {}
    for name, dependency in wanted:
        for built in recipe(name, ubuntu):
            found.setdefault(built.name, (_source(built), dependency))
    return tuple(found.values())


def _source(built: Recipe) -> Source:
    return Source(
        name=built.name,
        repo=built.repo,
        ref=built.ref,
        depends=built.depends,
        build="cmake",
        cmake_options=" ".join(built.options),
    )
