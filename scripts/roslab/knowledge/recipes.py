"""Libraries without a package: where their source is, at which ref, and how it is configured."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from roslab.config.model import Source
from roslab.evidence.facts import Dependency

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


@cache
def _table() -> dict[str, Any]:
    with Path(__file__).with_name("recipes.toml").open("rb") as stream:
        return tomllib.load(stream)


def recipe(name: str, ubuntu: str | None) -> tuple[Source, ...]:
    """Return what to build for a library, what it needs first; empty for one that the table does not have."""
    found = _table().get(name)
    if not isinstance(found, dict):
        return ()
    ref = found.get("ref_on", {}).get(ubuntu or "", found["ref"])
    depends = [*found.get("depends", ()), *found.get("depends_on", {}).get(ubuntu or "", ())]
    first = tuple(source for needed in found.get("after", ()) for source in recipe(needed, ubuntu))
    own = Source(
        name=name,
        repo=found["repo"],
        ref=ref,
        depends=tuple(depends),
        build="cmake",
        cmake_options=" ".join(found.get("options", ())),
    )
    return (*first, own)


def recipes_for(wanted: Iterable[tuple[str, Dependency]], ubuntu: str | None) -> tuple[tuple[Source, Dependency], ...]:
    """Return the sources of several libraries with what asked for each, every one once, in the order to build them."""
    found: dict[str, tuple[Source, Dependency]] = {}
    for name, dependency in wanted:
        for source in recipe(name, ubuntu):
            found.setdefault(source.name, (source, dependency))
    return tuple(found.values())
