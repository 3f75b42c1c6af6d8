"""Lists of folders without nodes that ask for a NumPy with which the nodes' modules of apt do not load."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.numpy_limit import limit_of
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.values.dataclass import replace
from roslab.values.requirement import Requirement

Loose = Mapping[Requirement, Warning_]
"""Lines that are installed without their version, each with what is told of it."""


def beside_nodes(evidence: Evidence, kind: Kind, ubuntu: str | None, files: Iterable[RequirementFile]) -> Loose:
    """Return the requirements that give way to the nodes, which share the Python of the list, each with what is told.

    A list at the root, or of a folder with a package of ROS, is the nodes' own: its author wants what it says.
    """
    folders = {each.file.rpartition("/")[0] for each in packages_of(evidence).built} if kind in {"ros1", "ros2"} else ()
    if not folders:
        return {}
    files = tuple(files)
    asked = [each for file in files for each in file.requirements if each.key == "numpy" and not each.url]
    outside = {file.file for file in files if _outside(file.file, folders)}
    asked = [each for each in asked if each.file in outside]
    nodes = tuple(each for each in evidence.code if any(_below(each.file, folder) for folder in folders))
    by_pip = {each.key for file in files for each in file.requirements if each.name}
    found = limit_of(replace(evidence, code=nodes), ubuntu or "", by_pip) if asked else None
    if found is None:
        return {}
    why = f"{found.used.name} of the nodes {found.why}"
    return {
        each: warn(f"{each.written} gives way to numpy<{found.below}: {why}", each)
        for each in asked
        if not each.specifier.contains(found.last)
    }


def _outside(file: str, folders: Iterable[str]) -> bool:
    folder = file.rpartition("/")[0]
    return bool(folder) and not any(_below(file, each) or _below(f"{each}/", folder) for each in folders)


def _below(path: str, folder: str) -> bool:
    return not folder or path.startswith(f"{folder}/")
