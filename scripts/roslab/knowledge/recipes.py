"""Libraries without a package: where their source is, which ref to build, and how to configure it."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from roslab.values import toml
from roslab.values.dataclass import dataclass


@cache
def _table() -> dict[str, Any]:
    return toml.parsed(Path(__file__).with_name("recipes.toml").read_text(encoding="utf-8"))


@dataclass(frozen=True, kw_only=True, slots=True)
class Recipe:
    """How one library is built by CMake."""

    name: str
    repo: str
    ref: str
    """A tag or a commit, so that the same is built in ten years."""
    depends: tuple[str, ...]
    """apt packages that its build needs."""
    options: tuple[str, ...]


def recipe(name: str, ubuntu: str | None) -> tuple[Recipe, ...]:
    """Return what to build for a library, its own needs first; empty if the table does not have it."""
    found = _table().get(name)
    if not isinstance(found, dict):
        return ()
    depends = (*found.get("depends", ()), *found.get("depends_on", {}).get(ubuntu or "", ()))
    own = Recipe(
        name=name,
        repo=found["repo"],
        ref=found.get("ref_on", {}).get(ubuntu or "", found["ref"]),
        depends=depends,
        options=tuple(found.get("options", ())),
    )
    return (*(first for needed in found.get("after", ()) for first in recipe(needed, ubuntu)), own)
