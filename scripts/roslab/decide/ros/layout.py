"""Where the repository lies in the image: a folder of a workspace, the workspace itself, or neither."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from roslab.config.model import Kind
from roslab.decide.decision import Reason
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.facts import Evidence


@dataclass(frozen=True, kw_only=True, slots=True)
class LayoutChoice:
    """The workspace's layout and the folder of a plain CMake project."""

    workspace: Literal["none", "overlay", "root"] = "none"
    cmake_folder: str = ""
    reasons: tuple[Reason, ...] = ()


def decide_layout(evidence: Evidence, kind: Kind, packages: Packages) -> LayoutChoice:
    """Return where the repository lies; it is the workspace itself where every package lies in its ``src``."""
    if kind in {"ros1", "ros2"}:
        if not packages.built:
            return LayoutChoice()
        inside = [manifest for manifest in packages.built if manifest.file.startswith("src/")]
        if len(inside) == len(packages.built) and not any(m.file.count("/") < 2 for m in inside):
            why = Reason(
                question="workspace",
                answer="root",
                reason="every package lies in src/",
                file=inside[0].file,
                line=1,
                weight=100,
            )
            return LayoutChoice(workspace="root", reasons=(why,))
        first = packages.built[0]
        why = Reason(
            question="workspace",
            answer="overlay",
            reason="its packages lie beside its other files",
            file=first.file,
            line=1,
            weight=100,
        )
        return LayoutChoice(workspace="overlay", reasons=(why,))
    tops = [project for project in evidence.cmake if project.top_level and not places.vendored(project.file)]
    tops.sort(key=lambda project: (project.file.count("/"), project.file))
    return LayoutChoice(cmake_folder=tops[0].file.rpartition("/")[0]) if tops else LayoutChoice()
