"""ROS packages that many repositories need, and that not every distribution released: their repository and its ref."""

from __future__ import annotations

import re
from functools import cache

from roslab.knowledge.distros import distros
from roslab.knowledge.record import grouped, record
from roslab.knowledge.released import released
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass

_COMMIT = re.compile(r"[0-9a-f]{40}")


@dataclass(frozen=True, kw_only=True, slots=True)
class RosSource:
    """A repository that holds one such package."""

    package: str
    repo: str
    ref: str
    """``{distro}`` stands for the ROS distribution, whose name the branch has."""
    library: str
    """The row of ``recipes.toml`` for a library that it links, ``""`` for none."""
    prepare: str
    """Shell commands that make the checkout a package, run in its folder (it has a manifest for each ROS version)."""
    options: str
    """CMake options that its build needs; ``{distro}`` stands for the ROS distribution."""
    cmake: str
    """The CMake that its own files ask for, where a usual Ubuntu's is too old, ``""`` for no such one."""


@cache
def _table() -> dict[tuple[str, str], dict[str, str]]:
    return {(row["package"], row["ros"]): row for row in rows("ros_sources")}


def ros_sources(package: str, ros: int, distro: str = "") -> tuple[RosSource, ...]:
    """Return what to clone for a package, its own needs first; empty if the table does not have it.

    So is what the given distribution released, and what exists for others alone.
    """
    row = _table().get((package, str(ros)))
    if row is None or package in released(distro):
        return ()
    if distro and row["distros"] and distro not in row["distros"].split():
        return ()
    first = {found.package: found for needed in row["after"].split() for found in ros_sources(needed, ros, distro)}
    own = record(RosSource, row, ref=row["ref"].format(distro=distro or "rolling"))
    return (*first.values(), own)


@cache
def _held() -> dict[str, tuple[str, ...]]:
    return grouped((_address(row["repo"]), row["package"]) for row in rows("ros_sources"))


def _address(repo: str) -> str:
    return repo.removesuffix(".git").lower()


def packages_at(repo: str) -> frozenset[str]:
    """Return the packages that the table knows in a repository."""
    return frozenset(_held().get(_address(repo), ()))


def held_by(repo: str, ros: int, distro: str = "") -> frozenset[str]:
    """Return the packages that the table finds in a repository, for a distribution that did not release them."""
    found = {package: ros_sources(package, ros, distro)[-1:] for package in packages_at(repo)}
    return frozenset(name for name, own in found.items() if any(_address(each.repo) == _address(repo) for each in own))


def day_of(source: RosSource, distro: str, day: str) -> str:
    """Return the day of which the table's commit is taken, ``""`` for the commit itself.

    A commit of 2025 may lack what a repository of 2023 includes, so its own day is taken: where the distribution was a
    year old by then, so that others had come to work on it. What is prepared or configured was tried at its commit.
    """
    known = distros().get(distro)
    if not (known and day and _COMMIT.fullmatch(source.ref)) or source.prepare or source.options:
        return ""
    year_before = f"{int(day[:4]) - 1}{day[4:]}"
    return day if year_before >= known.released else ""


@cache
def alone() -> frozenset[str]:
    """Return the repositories whose root is the package, so that they hold no other."""
    return frozenset(row["repo"] for row in rows("ros_sources") if row["alone"])


@cache
def collections() -> frozenset[str]:
    """Return the repositories that may hold others beside the packages that the table knows of them."""
    return frozenset(row["repo"] for row in rows("ros_sources")) - alone()
