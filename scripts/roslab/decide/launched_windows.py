"""The files of nodes in Python, which a command starts by their package and name, and the windows that these open."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.brought_launches import with_brought
from roslab.decide.launch_calls import started_launch
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence


def opened_by_nodes(evidence: Evidence, argv: tuple[str, ...]) -> tuple[Dependency, ...]:
    """Return the calls that open a window in the files of the nodes which a command starts."""
    calls = [each for each in evidence.code if each.namespace == "call" and each.role != "build"]
    files = files_of_nodes(evidence, argv) if calls else frozenset()
    return tuple(each for each in calls if each.file in files)


def files_of_nodes(evidence: Evidence, argv: tuple[str, ...]) -> frozenset[str]:
    """Return the files of the nodes in Python which a command starts.

    A node is called like its file, or it is the only program of its package.
    """
    nodes = _nodes(evidence, argv)
    if not nodes:
        return frozenset()
    folders = {manifest.name: manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    programs = [script.file for script in evidence.programs]
    files: set[str] = set()
    for package, program in nodes:
        folder = folders.get(package)
        inside = [file for file in programs if folder is not None and file.startswith(f"{folder}/" if folder else "")]
        files |= {file for file in inside if _stem(file) == _stem(program)} or {*inside[: len(inside) == 1]}
    return frozenset(files)


def switched_on(evidence: Evidence, words: Iterable[str]) -> bool:
    """Tell whether a command gives an argument another value than the one that keeps a viewer from being started."""
    given = {name: value.lower() for name, is_given, value in (word.partition(":=") for word in words) if is_given}
    kept = [(given[name], value) for launch in evidence.launch for name, value in launch.viewers if name in given]
    return any(said != value for said, value in kept)


def _nodes(evidence: Evidence, argv: tuple[str, ...]) -> frozenset[tuple[str, str]]:
    """Return the package and the program of each node that a command starts."""
    words = argv[1:3] if argv[0] == "rosrun" else argv[2:4] if argv[:2] == ("ros2", "run") else ()
    if len(words) > 1:
        return frozenset([(words[0], words[1])])
    launch = started_launch(evidence, argv)
    return frozenset(node for each in with_brought(evidence, launch) for node in each.nodes) if launch else frozenset()


def _stem(file: str) -> str:
    return file.rpartition("/")[2].removesuffix(".py")
