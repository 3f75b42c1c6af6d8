"""Read the lab's data files: facts about the world, each with its source and date."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

from .home import HERE

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


@cache
def table(name: str) -> dict[str, Any]:
    """Return a whole data file of the lab as a dictionary, by its name without `.toml`."""
    with (HERE / f"{name}.toml").open("rb") as handle:
        return tomllib.load(handle)


def fact(section: str, key: str) -> Any:
    """Return one value of facts.toml; a wrong name is an error of ours and raises KeyError."""
    return table("facts")[section][key]


def text(section: str, key: str) -> str:
    """Return one value of facts.toml that is a string."""
    return str(fact(section, key))


def texts(section: str, key: str) -> tuple[str, ...]:
    """Return one value of facts.toml that is a list of strings."""
    return tuple(str(value) for value in fact(section, key))


def number(section: str, key: str) -> int:
    """Return one value of facts.toml that is a whole number."""
    return int(fact(section, key))
