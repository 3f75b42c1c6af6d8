"""Where the repository lies in the image: a folder of a workspace, the workspace itself, or neither."""

from __future__ import annotations

from typing import Literal

from roslab.config.model import Kind
from roslab.decide.decision import Choice
from roslab.decide.programs import compiled, top_of
from roslab.decide.reasons import because
from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place

LAYOUT = 100
"""A single fact decides, so the weight has nothing to compete with."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Layout:
    """How the repository lies in the image."""

    workspace: Literal["none", "overlay", "root"] = "none"
    cmake_folder: str = ""
    """Folder of the top-level CMakeLists.txt of a plain CMake project."""
    program_folders: tuple[str, ...] = ()
    """Where its programs are: ``source/…``, relative to the repository's root, or ``build/…``."""


def decide_layout(evidence: Evidence, kind: Kind, packages: Packages) -> Choice[Layout]:
    """Return where the repository lies; it is the workspace itself if every package lies in its ``src``."""
    if kind not in {"ros1", "ros2"}:
        top = top_of(evidence)
        folders = tuple(dict.fromkeys(program.folder for program in compiled(evidence)))
        folder = top.file.rpartition("/")[0] if top else ""
        return Choice(answer=Layout(cmake_folder=folder, program_folders=folders))
    if not packages.built:
        return Choice(answer=Layout())
    first = Place(file=packages.built[0].file, line=1)
    if all(manifest.file.startswith("src/") and manifest.file.count("/") > 1 for manifest in packages.built):
        why = because("workspace", "root", "every package lies in src/", first, weight=LAYOUT)
        return Choice(answer=Layout(workspace="root"), reasons=(why,))
    why = because("workspace", "overlay", "its packages lie beside its other files", first, weight=LAYOUT)
    return Choice(answer=Layout(workspace="overlay"), reasons=(why,))
