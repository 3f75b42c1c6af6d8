"""Where the repository lies in the image: a folder of a workspace, the workspace itself, or neither."""

from __future__ import annotations

from typing import Literal

from roslab.config.model import Kind
from roslab.decide.decision import Choice, Warning_
from roslab.decide.linking_projects import linking
from roslab.decide.programs import beside_top, compiled, folders_of, top_of
from roslab.decide.reasons import because, warn
from roslab.decide.ros.as_sources import mounted_in, signs_of_sources
from roslab.decide.ros.not_built import warn_of_the_other_ros
from roslab.decide.ros.other_workspaces import warn_of_others
from roslab.decide.ros.source_names import address, plain
from roslab.decide.ros.submodule_packages import only_in_submodules
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place

LAYOUT = 100
"""A single fact decides, so the weight has nothing to compete with."""
_WRITTEN = {"ros1": "devel", "ros2": "install"}
"""The folder in which the setup script is that a workspace's build writes."""
MOST_NAMED = 6
"""Most folders that one warning names."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Layout:
    """How the repository lies in the image."""

    workspace: Literal["none", "overlay", "root"] = "none"
    cmake_folder: str = ""
    """Folder of the top-level CMakeLists.txt of a plain CMake project."""
    program_folders: tuple[str, ...] = ()
    """Where its programs are: ``source/…``, relative to the repository's root, ``build/…`` or ``beside/…``."""
    installed: bool = False
    """A page installs it, or other projects of the tree need its library."""
    set_up_links: tuple[Literal["inside", "beside"], ...] = ()
    """Where the tree looks for what the build of the workspace writes: in the repository's folder, as scripts of it
    do, or beside that, for the repository is the ``src`` of its author's workspace."""
    mounted: str = ""
    """That workspace in the author's container, ``""`` where it is not known."""


def decide_layout(evidence: Evidence, kind: Kind, packages: Packages) -> Choice[Layout]:
    """Return where the repository lies; it is the workspace itself if every package lies in its ``src``.

    catkin_make refuses a workspace with a CMakeLists.txt beside ``src`` (ros/catkin: bin/catkin_make, 2026-11-23).
    """
    if kind not in {"ros1", "ros2"}:
        top = top_of(evidence)
        folders = folders_of(compiled(evidence), evidence)
        folder = top.file.rpartition("/")[0] if top else ""
        warnings = _alone(evidence, top) if top and kind == "cpp" else ()
        installed = kind == "cpp" and (_installed(evidence) or bool(linking(evidence, top)))
        layout = Layout(cmake_folder=folder, program_folders=folders, installed=installed)
        return Choice(answer=layout, warnings=warnings)
    if not packages.built:
        said = only_in_submodules(evidence)
        all_cloned = "all of its packages lie in submodules, which the image clones, and a page builds them"
        reason = (because("workspace", "overlay", all_cloned, said, weight=LAYOUT),) if said else ()
        return Choice(answer=Layout(workspace="overlay" if said else "none"), reasons=reason)
    first = Place(file=packages.built[0].file, line=1)
    others = (*warn_of_others(evidence, packages.built, packages.doubles), *warn_of_the_other_ros(evidence, kind))
    refused = kind == "ros1" and any(project.file == "CMakeLists.txt" for project in evidence.cmake)
    in_src = all(manifest.file.startswith("src/") and manifest.file.count("/") > 1 for manifest in packages.built)
    if in_src and not refused:
        why = because("workspace", "root", "every package lies in src/", first, weight=LAYOUT)
        return Choice(answer=Layout(workspace="root"), reasons=(why,), warnings=others)
    reasons = [because("workspace", "overlay", "its packages lie beside its other files", first, weight=LAYOUT)]
    sourced = next((m for m in evidence.mentions if m.topic == "own_setup" and m.value == _WRITTEN[kind]), None)
    if sourced:
        link = "a script of the tree sources it: a link to that of the workspace"
        reasons.append(because("workspace", sourced.value, link, sourced, weight=LAYOUT))
    signs = signs_of_sources(evidence, _WRITTEN[kind])
    is_src = "the repository is the src of its author's workspace: what the build writes is linked beside it"
    reasons += [because("workspace", "overlay", is_src, sign, weight=LAYOUT) for sign in signs]
    links: tuple[tuple[Literal["inside", "beside"], object], ...] = (("inside", sourced), ("beside", signs))
    layout = Layout(
        workspace="overlay",
        set_up_links=tuple(place for place, found in links if found),
        mounted=mounted_in(evidence),
    )
    return Choice(answer=layout, reasons=tuple(reasons), warnings=others)


def _installed(evidence: Evidence) -> bool:
    """Tell whether a page at the root clones the repository itself, compiles it and installs it."""
    name = address(evidence.origin).rpartition("/")[2] if evidence.origin else ""
    pages = (git for git in evidence.sources if git.kind == "clone" and git.installed and "/" not in git.file)
    return any(git.itself or (name and plain(git.name) == plain(name)) for git in pages)


def _alone(evidence: Evidence, top: CMakeProject) -> tuple[Warning_, ...]:
    """Warn where folders beside the one that is compiled hold CMake projects of their own, which nothing compiles."""
    folder = top.file.rpartition("/")[0]
    own = (project for project in evidence.cmake if project.top_level and project.name and not project.lacks)
    own = (project for project in own if not (places.aside(project.file) or places.documentation(project.file)))
    paths = sorted({project.file.rpartition("/")[0] for project in own})
    compiled_too = (*beside_top(evidence), *(project for project, _ in linking(evidence, top)))
    done = {folder, *(project.file.rpartition("/")[0] for project in compiled_too)}
    others = [path for path in paths if not any(path in done or path.startswith(f"{each}/") for each in paths)]
    if not folder or not others:
        return ()
    named = ", ".join(others[:MOST_NAMED]) + (" …" if len(others) > MOST_NAMED else "")
    message = f"of the folders with a CMake project of their own {folder} is compiled, not {named}"
    return (warn(f"{message}; compile the others under `custom` in roslab.yaml", top),)
