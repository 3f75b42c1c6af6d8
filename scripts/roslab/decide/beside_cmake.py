"""Packages of ROS below a project of C++ that is built by CMake alone: samples, and descriptions that programs read."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.programs import top_of
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import replace


def without_packages_beside(evidence: Evidence, kind: Kind) -> Evidence:
    """Return the evidence without the packages that nothing builds, as they are no part of the project.

    What the project's CMakeLists.txt adds is a part of it, and no package.
    """
    top = top_of(evidence) if kind == "cpp" and evidence.manifests else None
    folders = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    if top is None or top.file.rpartition("/")[0] in folders:
        return evidence
    parts = {project.file.rpartition("/")[0] for project in evidence.cmake if project.added}
    beside = (m for m in evidence.manifests if m.file.rpartition("/")[0] not in parts)
    return replace(evidence, manifests=tuple(replace(manifest, ignored=True) for manifest in beside))
