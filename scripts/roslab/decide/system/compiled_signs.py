"""Signs of versions in the code: of a workspace, those that stand in what its packages compile."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.ros.workspace import packages_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def with_compiled_signs(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence without the signs in separate projects of CMake beside the packages of a workspace.

    No build tool of ROS compiles those.
    """
    packages = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    if kind not in {"ros1", "ros2"} or not packages or not evidence.limits:
        return evidence
    projects = {project.file.rpartition("/")[0] for project in evidence.cmake if project.top_level}
    beside = [
        folder
        for folder in projects
        if folder and not any(_in(folder, package) or _in(package, folder) for package in packages)
    ]
    kept = tuple(limit for limit in evidence.limits if not any(_in(limit.file, folder) for folder in beside))
    return replace(evidence, limits=kept)


def _in(path: str, folder: str) -> bool:
    return not folder or f"{path}/".startswith(f"{folder}/")
