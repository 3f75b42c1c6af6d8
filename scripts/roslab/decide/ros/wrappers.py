"""ROS packages that only wrap a Python program, or that pip installs: ROS is an extra of such a repository."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.config.model import WORKSPACE_TOOLS
from roslab.decide.python.manifests import resolve
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

SMALL_WRAPPER = 3
"""A Python program with at most this many ROS packages below its root only has a ROS wrapper."""
_OF_ROS = pattern(r"(?:^|/)ros:")
_STARTERS = ("roslaunch", "rosrun", "ros2")


def wraps(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether the ROS packages with these manifests are an extra of a Python program."""
    if _in_service(evidence, manifests):
        return False
    return _wrapper(evidence, manifests) or _of_library(evidence, manifests) or _by_pip(evidence, manifests)


def _in_service(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether a page has Docker Compose start an image of ROS that holds one of the packages."""
    images = [each for each in evidence.dockerfiles if each.service and _OF_ROS.search(each.base or "")]
    held = {source for each in images for source in each.copied}
    return any(not held.isdisjoint({"", *_above(file)}) for file in manifests)


def _above(file: str) -> Iterator[str]:
    """Yield the folders that a file lies in."""
    while file := file.rpartition("/")[0]:
        yield file


def run_by_page(evidence: Evidence) -> Mention | None:
    """Return where a page at the root runs Python outside of all ROS packages, if none there names anything of ROS."""
    folders = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    if not folders or "" in folders or _of_ros(evidence):
        return None
    plain = (program for program in evidence.programs if program.kind != "node")
    programs = {program.file for program in plain if not _within(program.file, folders)}
    said = (m for m in evidence.mentions if m.topic == "command" and m.source == "readme" and "/" not in m.file)
    run = (m for m in said if m.value.startswith("python"))
    return next((m for m in run if programs & set(map(posixpath.normpath, m.value.split()[1:]))), None)


def _of_ros(evidence: Evidence) -> bool:
    """Tell whether a page at the root builds or starts anything with ROS's tools."""
    said = [m for m in evidence.mentions if m.source == "readme" and "/" not in m.file]
    builds = any(m.topic == "build_tool" and m.value in WORKSPACE_TOOLS for m in said)
    return builds or any(m.topic == "command" and m.value.startswith(_STARTERS) for m in said)


def _wrapper(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether the ROS packages only wrap a Python program: few, deep, and most code lies outside them."""
    folders = {file.rpartition("/")[0] for file in manifests}
    if not manifests or "" in folders or len(folders) > SMALL_WRAPPER:
        return False
    compiled = any(project.executables and _within(project.file, folders) for project in evidence.cmake)
    depth = 0 if compiled else 2  # packages of C++ nodes count more than requirements of some script
    own = [p.file for p in evidence.python if p.meant] + [c.file for c in evidence.conda]
    own += [r.file for r in evidence.requirements if r.purpose == "run"]
    outside = (f for f in own if f.count("/") <= depth and not _within(f, folders) and not places.vendored(f))
    if not any(outside) and run_by_page(evidence) is None:
        return False
    code = {d.file for d in evidence.code if d.namespace == "import"} | {script.file for script in evidence.programs}
    inside = sum(_within(file, folders) for file in code)
    return 2 * inside < len(code)


def _of_library(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether the only package is the root of a Python library, which a page has pip install: nodes are extras.

    It compiles nothing, setup.py asks for what pip installs, and most programs are none of ROS's.
    """
    library = any(p.meant and not p.folder and p.requirements for p in evidence.python)
    if set(manifests) != {"package.xml"} or not library or any(project.executables for project in evidence.cmake):
        return False
    by_page = any(asked.role == "project" and asked.written in {".", "./"} for asked in _of_pages(evidence))
    nodes = sum(program.kind == "node" for program in evidence.programs)
    return by_page and 2 * nodes < len(evidence.programs)


def _by_pip(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether pages have pip install the folder of each package, and the page at the root nothing of ROS."""
    folders = {file.rpartition("/")[0] for file in manifests}
    usable = {project.folder for project in evidence.python if project.meant}
    piped = {resolve(asked, usable) for asked in _of_pages(evidence) if asked.role == "project"}
    return "" not in folders and folders <= piped and not _of_ros(evidence)


def _of_pages(evidence: Evidence) -> Iterator[Requirement]:
    return (asked for asked in evidence.prose_pip if asked.file.endswith((".md", ".rst", ".txt")))


def _within(file: str, folders: set[str]) -> bool:
    return any(file.startswith(folder + "/") for folder in folders)
