"""Folders of C++ in a repository of Python that a page has CMake compile: the image compiles them where they lie."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.system.inside import meant
from roslab.decide.system.names import Target, resolve
from roslab.evidence import places
from roslab.evidence.facts import CMakeProject, Evidence, Mention

_ASIDE = (places.vendored, places.test, places.example, places.documentation)
_OF_ROS = frozenset({"catkin", "ament", "rosbuild"})


def compiled_beside(evidence: Evidence, target: Target) -> Iterator[tuple[CMakeProject, Mention]]:
    """Yield each project with the line that compiles it: of the page at the root, or of the page in its own folder.

    What setup.py compiles by CMake is left to pip, and what needs a library that no package has to its author.
    """
    by_pip = {project.folder for project in evidence.python if "cmake" in project.extensions}
    projects = {
        folder: project
        for project in evidence.cmake
        if (folder := project.file.rpartition("/")[0]) and project.top_level and not project.lacks
        if folder not in by_pip and not any(aside(project.file) for aside in _ASIDE)
    }
    found: dict[str, Mention] = {}
    for mention in evidence.mentions:
        if mention.topic == "compiled" and mention.source == "readme":
            page = mention.file.rpartition("/")[0]
            named = (page if mention.value == "." else meant(mention.value, projects.keys())) or ""
            if named in projects and page in {"", named}:
                found.setdefault(named, mention)
    for folder, mention in found.items():
        if _compiles(folder, evidence, target):
            yield projects[folder], mention


def _compiles(folder: str, evidence: Evidence, target: Target) -> bool:
    """Tell whether the image has all that CMake requires in a folder and below."""
    own = {project.name for project in evidence.cmake} | evidence.cmake_modules
    for project in evidence.cmake:
        if project.file.startswith(f"{folder}/"):
            if _OF_ROS & {*project.macros} or ("cuda" in project.macros and not target.cuda):
                return False
            for asked in project.dependencies:
                required = asked.strength == "declared" and asked.role != "test" and asked.name not in own
                if required and asked.namespace in {"cmake", "pkg-config"}:
                    found = resolve(asked, target)
                    if not found.known or found.recipe:
                        return False
    return True
