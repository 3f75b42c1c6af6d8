"""Which launch files of the tree another one brings, told apart by package and name."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile


def brought(evidence: Evidence) -> Mapping[str, frozenset[str]]:
    """Return the paths of those that each launch file names, by its own path.

    A file named without its package is that of the same package, where it has one, else any of this name.
    """
    named: dict[str, list[LaunchFile]] = {}
    for launch in evidence.launch:
        named.setdefault(launch.file.rpartition("/")[2], []).append(launch)
    return {launch.file: frozenset(_brought(launch, named)) for launch in evidence.launch}


def _brought(launch: LaunchFile, named: Mapping[str, list[LaunchFile]]) -> set[str]:
    said: dict[str, set[str | None]] = {}
    for package, name in launch.included:
        said.setdefault(name, set()).add(package)
    found: set[str] = set()
    for name in {*launch.includes, *said}:
        files = named.get(name, [])
        own = {launch.package} if any(each.package == launch.package for each in files) else None
        packages = said.get(name, own)
        found |= {each.file for each in files if packages is None or each.package in packages}
    return found - {launch.file}


def all_brought(file: str, brings: Mapping[str, frozenset[str]]) -> set[str]:
    """Return the paths of those that a launch file brings at any depth."""
    found: set[str] = set()
    pending = [file]
    while pending:
        new = brings[pending.pop()] - found - {file}
        found |= new
        pending += sorted(new)
    return found


def file_of(argv: tuple[str, ...], evidence: Evidence) -> str | None:
    """Return the path of the launch file that a call of ``roslaunch`` or ``ros2 launch`` starts, ``None`` for none."""
    package, name = argv[-2:]
    inside = [each.file for each in evidence.launch if each.package == package and each.file.endswith(f"/{name}")]
    found = inside or [launch.file for launch in evidence.launch if launch.file == name]
    return found[0] if len(found) == 1 else None
