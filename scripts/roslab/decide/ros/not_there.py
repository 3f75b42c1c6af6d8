"""What packages install and the repository does not have, at which ``cmake --install`` ends."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Choice, Warning_
from roslab.decide.programs import owner
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import Packages
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence
from roslab.evidence.installed_path import InstalledPath
from roslab.values.origin import Place

MOST_NAMED = 6
"""Most paths that one warning names."""


def decide_not_there(
    evidence: Evidence, config: Config, packages: Packages, left_out: Collection[str], build_tool: BuildTool
) -> Choice[tuple[str, ...]]:
    """Return the folders, each with a ``/`` behind it, and files that are made, empty, before the build.

    Only where the tool installs what it builds: catkin's devel space needs none of them.
    """
    installs = build_tool == "colcon" or any(word in {"install", "--install"} for word in config.build_args)
    if config.compatible or not installs:
        return Choice(answer=())
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name not in left_out}
    found = [
        (project, each) for project in evidence.cmake if owner(project.file, folders) for each in project.not_there
    ]
    return Choice(answer=tuple(sorted({_written(each) for _, each in found})), warnings=tuple(_warnings(found)))


def _written(each: InstalledPath) -> str:
    return f"{each.path}/" if each.folder else each.path


def _warnings(found: Sequence[tuple[CMakeProject, InstalledPath]]) -> Iterator[Warning_]:
    """Yield one warning for the folders and one for the files."""
    for folders, what in (
        (True, "folders, and git keeps no empty ones"),
        (False, "files, perhaps as git ignores them"),
    ):
        these = [(project, each) for project, each in found if each.folder == folders]
        paths = list(dict.fromkeys(_written(each) for _, each in these))
        if paths:
            named = ", ".join(paths[:MOST_NAMED]) + (" …" if len(paths) > MOST_NAMED else "")
            message = f"the repository does not have {named}, which its CMake installs ({what}): made empty"
            yield warn(message, Place(file=these[0][0].file, line=these[0][1].line))
