"""Where the repository lies in the image: a folder of a workspace, the workspace itself, or neither."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from roslab.config.model import Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place

LAYOUT = 100
"""A single fact decides, so the weight has nothing to compete with."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Layout:
    """How the repository lies in the image."""

    workspace: Literal["none", "overlay", "root"] = "none"
    cmake_folder: str = ""
    """Folder of the top-level CMakeLists.txt of a plain CMake project."""


def decide_layout(evidence: Evidence, kind: Kind, packages: Packages) -> Choice[Layout]:
    """Return where the repository lies; it is the workspace itself if every package lies in its ``src``."""
    if kind not in {"ros1", "ros2"}:
        tops = [project for project in evidence.cmake if project.top_level and not places.vendored(project.file)]
        top = min(tops, key=lambda project: (project.file.count("/"), project.file), default=None)
        return Choice(answer=Layout(cmake_folder=top.file.rpartition("/")[0] if top else ""))
    if not packages.built:
        return Choice(answer=Layout())
    first = Place(file=packages.built[0].file, line=1)
    if all(manifest.file.startswith("src/") and manifest.file.count("/") > 1 for manifest in packages.built):
        why = because("workspace", "root", "every package lies in src/", first, weight=LAYOUT)
        return Choice(answer=Layout(workspace="root"), reasons=(why,))
    why = because("workspace", "overlay", "its packages lie beside its other files", first, weight=LAYOUT)
    return Choice(answer=Layout(workspace="overlay"), reasons=(why,))
