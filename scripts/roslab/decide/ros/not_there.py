"""What packages install, or keep data in, and the repository does not have: git keeps no empty folders."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Choice, Warning_
from roslab.decide.programs import configured_by
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import Packages
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.installed_path import InstalledPath
from roslab.values.origin import Place

MOST_NAMED = 6
"""Most paths that one warning names."""


def decide_not_there(
    evidence: Evidence, config: Config, packages: Packages, left_out: Collection[str], build_tool: BuildTool
) -> Choice[tuple[str, ...]]:
    """Return the folders, each with a ``/`` behind it, and files that are made, empty, before the build.

    What is installed only where the tool installs what it builds, for ``cmake --install`` ends there: catkin's devel
    space needs none of it. But it finds packages where their source lies, with the folders in which code has data.
    """
    installs = build_tool == "colcon" or any(word in {"install", "--install"} for word in config.build_args)
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name not in left_out}
    if config.compatible:
        return Choice(answer=())
    data = tuple(_of_data(evidence, folders)) if build_tool.startswith("catkin") else ()
    made = tuple(f"{each.value}/" for each in data)
    if not installs:
        return Choice(answer=made, warnings=tuple(map(_lost, data)))
    found = [
        (project, each) for project in evidence.cmake if configured_by(project, folders) for each in project.not_there
    ]
    answer = tuple(sorted({*made, *(_written(each) for _, each in found)}))
    return Choice(answer=answer, warnings=(*map(_lost, data), *_warnings(found)))


def _of_data(evidence: Evidence, folders: Mapping[str, str | None]) -> Iterator[Mention]:
    """Yield the folders of data of the packages that are built, also of files that lie elsewhere."""
    lost = (m for m in evidence.mentions if m.topic == "lost_folder")
    yield from (m for m in lost if any(not folder or m.value.startswith(f"{folder}/") for folder in folders))


def _lost(folder: Mention) -> Warning_:
    if folder.files:
        (there,) = folder.files
        name = f"{folder.value}/{there.rpartition('/')[2]}"
        return warn(f"{name} is named there, and the repository has {there}: correct the path", folder)
    why = "git keeps no empty folders, and its code has files there: made empty"
    return warn(f"the repository does not have {folder.value}/ ({why})", folder)


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
