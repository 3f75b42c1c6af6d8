"""C++ in a repository of Python that a page has CMake compile: the image compiles it where it lies."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.ros.source_names import plain
from roslab.decide.system.inside import meant
from roslab.decide.system.names import Target, resolve
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence, Mention

_ASIDE = (places.test, places.example, places.documentation)
_OF_ROS = frozenset({"catkin", "ament", "rosbuild"})


def compiled_beside(evidence: Evidence, target: Target) -> Iterator[tuple[CMakeProject, Mention, str]]:
    """Yield each project with the line that compiles it: of the page at the root, or of the page in its own folder.

    Last comes what CMake requires of it and the image lacks, which leaves it to its author, ``""`` for nothing. What
    setup.py compiles by CMake is left to pip. At the root lies a project beside an environment or a list of packages,
    where pip installs nothing.
    """
    by_pip = {project.folder for project in evidence.python if "cmake" in project.extensions}
    own = any(project.installable and project.folder in {"", "."} for project in evidence.python)
    projects = {
        folder: project
        for project in evidence.cmake
        if project.top_level and not project.lacks and ((folder := project.file.rpartition("/")[0]) or not own)
        if folder not in by_pip and not any(aside(project.file) for aside in _ASIDE)
    }
    root = projects.get("")
    itself = {plain(root.name or ""), plain(evidence.origin.rpartition("/")[2].removesuffix(".git"))} if root else {""}
    itself -= {""}
    found: dict[str, Mention] = {}
    for mention in evidence.mentions:
        if mention.topic == "compiled" and mention.source == "readme" and not places.vendored(mention.file):
            page = mention.file.rpartition("/")[0]
            named = page if mention.value == "." else meant(mention.value, projects.keys() - {""})
            if named is None and plain(mention.value.rpartition("/")[2]) in itself:
                named = ""
            if named is not None and named in projects and page in {"", named}:
                found.setdefault(named, mention)
    for folder, mention in found.items():
        yield projects[folder], mention, _lacking(folder, evidence, target)


def _lacking(folder: str, evidence: Evidence, target: Target) -> str:
    """Return the first thing that CMake requires in a folder and below and that the image lacks.

    What a copy of others' code requires is not installed for it.
    """
    own = {project.name for project in evidence.cmake} | evidence.cmake_modules
    for project in evidence.cmake:
        if project.file.startswith(f"{folder}/".lstrip("/")) and not (not folder and places.aside(project.file)):
            if _OF_ROS & {*project.macros} or ("cuda" in project.macros and not target.cuda):
                return "ROS" if _OF_ROS & {*project.macros} else "CUDA"
            for asked in project.dependencies:
                required = asked.strength == "declared" and asked.role != "test" and asked.name not in own
                if required and asked.namespace in {"cmake", "pkg-config"}:
                    found = resolve(asked, target)
                    if not found.known or found.recipe or places.vendored(project.file):
                        return asked.name
    return ""
