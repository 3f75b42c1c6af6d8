"""The releases of Gazebo and the distribution of ROS 2 that each was packaged for."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from roslab.knowledge.table import rows


@cache
def gazebo_releases() -> Mapping[str, str]:
    """Return the distribution for each release: ``harmonic``."""
    return {row["name"]: row["distro"] for row in rows("gazebo_releases")}


@cache
def gazebo_libraries() -> Mapping[str, str]:
    """Return the release for each library that has its number in its name: ``gz-sim8``."""
    return {library: row["name"] for row in rows("gazebo_releases") for library in row["libraries"].split()}


@cache
def gazebo_holding() -> Mapping[str, frozenset[str]]:
    """Return the releases that hold each library from Gazebo 7 on, and simulator: ``gz-cmake3`` is of two.

    Of the older ones, Gazebo 11 and Ubuntu itself have most, so that these tell nothing.
    """
    found: dict[str, set[str]] = {}
    for row in rows("gazebo_releases"):
        for library in (*row["libraries"].split(), *row["below"].split()):
            if library.startswith(("gz-", "ignition-gazebo")):
                found.setdefault(library, set()).add(row["name"])
    return {library: frozenset(names) for library, names in found.items()}


@cache
def gazebo_pairs() -> Mapping[tuple[str, str], str]:
    """Return, for a distribution and a release that is not its own, what its packages of ros_gz are called."""
    return {(row["distro"], row["release"]): row["packages"] for row in rows("gazebo_pairs")}


@cache
def replaced_keys(distro: str, release: str) -> tuple[str, ...]:
    """Return the packages of the distribution's own ros_gz, which those for such a release take the place of."""
    keys = (row["keys"] for row in rows("gazebo_pairs") if (row["distro"], row["release"]) == (distro, release))
    return tuple(next(keys, "").split())
