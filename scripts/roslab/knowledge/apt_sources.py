"""Package sources that an image has already or needs none of, and the keys of others by https."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.record import record
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern


@dataclass(frozen=True, kw_only=True, slots=True)
class AddedSource:
    """A package source that has packages which no archive of Ubuntu has."""

    packages: re.Pattern[str]
    ubuntu: tuple[str, ...]
    """The releases that it has them for; its suites are called so."""
    url: str
    components: str
    """``""`` for a source without suites."""
    key: str
    base: re.Pattern[str]
    """The names of images that have the source; the empty pattern for none."""
    folder: str
    """Where its packages have their ``bin``, ``lib`` and ``include``, ``""`` where that is Ubuntu's own place."""


@cache
def known_sources() -> dict[str, str]:
    """Return the hosts of package sources that are not added, each with the reason."""
    return {row["host"]: row["why"] for row in rows("apt_sources") if row["why"]}


@cache
def keys_of_sources() -> dict[str, str]:
    """Return the address of the key of a host's packages, by https: older pages fetch it without."""
    return {row["host"]: row["key"] for row in rows("apt_sources") if row["key"]}


@cache
def added_sources() -> tuple[AddedSource, ...]:
    """Return the sources that are added for what is installed, whether a page adds them or not."""
    return tuple(
        record(AddedSource, row, packages=pattern(row["packages"]), base=pattern(row["base"]))
        for row in rows("added_sources")
    )


def folder_of_source(line: str) -> str:
    """Return the folder in which the packages of a line of apt's sources lie, ``""`` for Ubuntu's own."""
    known = (each for each in added_sources() if each.folder and f" {each.url} " in f" {line} ")
    return next((each.folder for each in known), "")


def folder_of_package(name: str) -> str:
    """Return the folder in which a package of an added source lies, ``""`` for Ubuntu's own."""
    known = (each for each in added_sources() if each.folder and each.packages.fullmatch(name))
    return next((each.folder for each in known), "")
