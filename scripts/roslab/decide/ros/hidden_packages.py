"""Packages below a project of plain CMake, or inside another package, where colcon does not look by itself."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import because, warn
from roslab.decide.ros.base_paths import BASE_PATHS, base_paths
from roslab.decide.ros.workspace import Packages
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.values.dataclass import dataclass
from roslab.values.words import line_of

WEIGHT = 60
_OF_CATKIN = "Project"
"""The name of the project in the CMakeLists.txt that catkin puts into a workspace, which colcon passes by."""
_TOLD = "colcon is told of it, which takes the project above for a package and looks for none below"
_INSIDE = "{}: colcon is told of it, which looks for none inside another package"
_NEEDED, _NAMED = "another package of the repository needs it", "a page tells colcon of its folder"
_NOT_BUILT = "not built, for no package of ROS below this project asks for it; compile it under `custom` in roslab.yaml"


@dataclass(frozen=True, kw_only=True, slots=True)
class Hidden:
    """The packages to which colcon does not come by itself."""

    folders: tuple[str, ...] = ()
    """Theirs, which it has to be told."""
    above: tuple[str, ...] = ()
    """Those of the projects above that no package needs and the default command does not start."""


def decide_hidden(
    evidence: Evidence,
    config: Config,
    packages: Packages,
    build_tool: BuildTool,
    *,
    command: tuple[str, ...] | str,
    left_out: Collection[str],
) -> Choice[Hidden]:
    """Return the packages of which colcon is told; ``left_out`` are those that are not built.

    None where roslab.yaml tells colcon where to look: of two such arguments the last one counts.
    Each folder with a CMakeLists.txt is a package to colcon, which looks for no others below it. Whoever made such a
    repository builds in a folder below, so that the project above is built only where it is needed. What that adds
    itself is a part of it. https://github.com/colcon/colcon-cmake (package_identification/cmake.py) and
    https://github.com/colcon/colcon-recursive-crawl, read 2026-11-28
    """
    if build_tool != "colcon" or config.compatible or any(each.startswith(BASE_PATHS) for each in config.build_args):
        return Choice(answer=Hidden())
    projects = {project.file.rpartition("/")[0]: project for project in evidence.cmake}
    built = [m for m in packages.built if m.name not in left_out]
    own = {manifest.file.rpartition("/")[0] for manifest in built}
    hiding: dict[str, list[str]] = {}
    outer = {manifest.file.rpartition("/")[0]: manifest for manifest in packages.built}
    inside: dict[str, PackageManifest] = {}
    for folder in sorted(own):
        for above in _above(folder) if not (folder in projects and projects[folder].added) else ():
            project = projects.get(above)
            if above in outer:
                inside[folder] = outer[above]
            elif project and not project.ignored and project.name != _OF_CATKIN:
                hiding.setdefault(folder, []).append(above)
    tops = {above for there in hiding.values() for above in there}
    names = {d.name.lower() for m in built if m.file.rpartition("/")[0] in hiding for d in m.dependencies}
    names |= {d.name.lower() for folder in hiding if folder in projects for d in projects[folder].dependencies}
    started = {word.rpartition("/")[2] for word in line_of(command).split()}
    kept = {top for top in tops if _names(evidence, top) & names or _makes(evidence, top) & started}
    told = {m.name or "": projects[hiding[folder][0]] for m in built if (folder := m.file.rpartition("/")[0]) in hiding}
    reasons = [because("workspace", name, _TOLD, project, weight=WEIGHT) for name, project in told.items()]
    named = base_paths(evidence) if inside else ()
    for folder, around in inside.items():
        why = _INSIDE.format(_NAMED if folder.rpartition("/")[2] in named else _NEEDED)
        reasons.append(because("workspace", folder, why, around, weight=WEIGHT))
    warnings = (warn(_NOT_BUILT, projects[top]) for top in sorted(tops - kept))
    answer = Hidden(folders=tuple(sorted({*hiding, *inside})), above=tuple(sorted(tops - kept)))
    return Choice(answer=answer, reasons=tuple(reasons), warnings=tuple(warnings))


def _above(folder: str) -> Iterator[str]:
    while folder:
        folder = folder.rpartition("/")[0]
        yield folder


def _names(evidence: Evidence, top: str) -> set[str]:
    """Return the names by which others may find the project in a folder, in small letters."""
    of_it = [project for project in evidence.cmake if project.top == top]
    own = (project.name for project in of_it if project.file.rpartition("/")[0] == top)
    return {name.lower() for name in (*own, *(name for project in of_it for name in project.configs)) if name}


def _makes(evidence: Evidence, top: str) -> set[str]:
    """Return the programs that the project in a folder, or what it adds, makes."""
    made = (name for project in evidence.cmake if project.top == top for name, _ in project.executables)
    return {name.rpartition("/")[2] for name in made}
