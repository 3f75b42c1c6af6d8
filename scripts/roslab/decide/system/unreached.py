"""Projects of CMake that no build of the image comes to: what they look for is no need of it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from functools import lru_cache

from roslab.decide.linked_projects import linked_projects
from roslab.decide.linking_projects import linking
from roslab.decide.programs import beside_top, top_of
from roslab.decide.system.added_projects import added_by, folder_of
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence

_SAYS = frozenset({"compiled", "installed_here", "build_script", "make"})
_HEADERS = "include"
DEEPEST = 32
"""Most folders of a path, the last ones, that are compared."""


@lru_cache(maxsize=4)
def unreached(evidence: Evidence, *, by_page: bool = True) -> frozenset[str]:
    """Return the files of projects beside the one that is built, which adds none of them, and of what these add.

    Not those that are compiled beside it. ``by_page``: nor those that a page or a script compiles, whether the image
    does so or not. Nothing where packages of ROS are built.
    """
    top = top_of(evidence)
    alone = [project for project in evidence.cmake if project.top_level and project is not top]
    if top is None or evidence.manifests or not alone:
        return frozenset()
    own = [each.folder for each in evidence.python if each.installable]
    above = {
        each
        for each in own
        if not any(other != each and f"{each}/".startswith(f"{other}/".lstrip("/")) for other in own)
    }
    python = {each.folder for each in evidence.python if "cmake" in each.extensions} & above
    built = [
        top,
        *beside_top(evidence),
        *(p for p, _ in linking(evidence, top)),
        *(p for p, _ in linked_projects(evidence)),
    ]
    built += [p for p in alone if folder_of(p) in python]
    built += list(_said(alone, evidence)) if by_page else []
    added = added_by(built, evidence.cmake)
    folders = {folder_of(project) for project in added.projects}
    left = {
        folder_of(p)
        for p in alone
        if folder_of(p) not in folders and not any(p.file.startswith(begins) for begins in added.unknown)
    }
    return frozenset(
        each.file for each in evidence.cmake if folder_of(each) in left or (each.added and each.top in left - {""})
    )


def _said(projects: Iterable[CMakeProject], evidence: Evidence) -> Iterator[CMakeProject]:
    """Yield the projects in, or above, whose folders a page or a script compiles something.

    What lies among the headers is a copied library, whose own page tells how it is compiled by itself.
    """
    said = [each for each in evidence.mentions if each.topic in _SAYS and _HEADERS not in each.file.split("/")[:-1]]
    places = {posixpath.normpath(mention.value.split(" ")[0]) for mention in said}
    places |= {posixpath.dirname(mention.file) for mention in said}
    inside = {part for place in places for part in _parts(place)}
    yield from (project for project in projects if folder_of(project) in inside)


def _parts(place: str) -> Iterator[str]:
    """Yield every run of folders of a path, which may begin above the tree, and the root where it is that."""
    words = place.strip("/").split("/")[-DEEPEST:]
    if not place or place.startswith("/"):
        yield ""
    for start in range(len(words)):
        for end in range(start + 1, len(words) + 1):
            yield "/".join(words[start:end])
