"""Packages outside of the workspace that the page builds: the author may never have built them with the others."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.launch_calls import started_launch
from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence, Mention, PackageManifest
from roslab.values.words import line_of

_TOOLS = frozenset({"colcon", "catkin_make", "catkin_tools", "catkin_make_isolated"})


def outside(
    evidence: Evidence, packages: Packages, command: tuple[str, ...] | str
) -> Iterator[tuple[PackageManifest, Mention]]:
    """Yield the packages outside of the one folder with ``src`` that a page at the root builds, each with its line.

    Not those that a package inside needs, nor what the default command starts and launches.
    """
    said = [m for m in evidence.mentions if m.topic == "build_tool" and m.source == "readme" and "/" not in m.file]
    said = [m for m in said if m.value in _TOOLS]
    places = {m: _workspace(m.inside, packages) for m in said}
    folders = {*places.values()}
    if len(folders) != 1 or folders == {""}:
        return
    folder = f"{folders.pop()}/"
    inside = [m for m in packages.built if m.file.startswith(folder)]
    launch = started_launch(evidence, command)
    launched = {asked.name for asked in (*launch.dependencies, *launch.reached)} if launch else set()
    needed = {d.name for m in inside for d in m.dependencies} | {*line_of(command).split()} | launched
    others = {m.name: m for m in packages.built if m.name and m not in inside}
    pending = [name for name in others if name in needed]
    for name in pending:
        more = [d.name for d in others[name].dependencies if d.name in others and d.name not in pending]
        pending += dict.fromkeys(more)
    yield from ((manifest, said[0]) for name, manifest in others.items() if name not in pending)


def _workspace(inside: str, packages: Packages) -> str:
    """Return the folder of the tree with packages in its ``src`` that a page's folder is, ``""`` for none.

    Its path may begin above the repository.
    """
    parts = inside.strip("/").split("/")
    paths = ["/".join(parts[start:]) for start in range(len(parts))] if inside else []
    return next((path for path in paths if any(m.file.startswith(f"{path}/src/") for m in packages.built)), "")
