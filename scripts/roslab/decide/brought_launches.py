"""Which launch files of the tree another one brings, told apart by package and name."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile

Brings = Mapping[str, tuple[LaunchFile, ...]]
"""The launch files that each one names, by its path."""


def brought(evidence: Evidence) -> Brings:
    """Return what each launch file names.

    A file named without its package is that of the same package, where it has one, else any of this name.
    """
    named: dict[str, list[LaunchFile]] = {}
    for launch in evidence.launch:
        named.setdefault(launch.file.rpartition("/")[2], []).append(launch)
    return {launch.file: tuple(_brought(launch, named)) for launch in evidence.launch}


def _brought(launch: LaunchFile, named: Mapping[str, list[LaunchFile]]) -> Iterator[LaunchFile]:
    said: dict[str, set[str]] = {}
    for package, name in launch.includes:
        said.setdefault(name, set()).add(package)
    for name, packages in said.items():
        files = named.get(name, [])
        if "" in packages:
            found = [each for each in files if each.package == launch.package] or files
        else:
            found = [each for each in files if each.package in packages]
        yield from (each for each in found if each.file != launch.file)


def all_brought(launch: LaunchFile, brings: Brings) -> tuple[LaunchFile, ...]:
    """Return those that a launch file brings at any depth, the nearest first."""
    found = {launch.file: launch}
    pending = [launch]
    for each in pending:
        new = {other.file: other for other in brings[each.file] if other.file not in found}
        found |= new
        pending += new.values()
    return tuple(pending[1:])


def with_brought(evidence: Evidence, launch: LaunchFile) -> tuple[LaunchFile, ...]:
    """Return a launch file and those that it brings at any depth."""
    return (launch, *all_brought(launch, brought(evidence)))
