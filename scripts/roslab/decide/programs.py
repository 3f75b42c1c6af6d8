"""The programs that CMake compiles: which there are, and the folders that they are written to."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Container, Iterable, Iterator, Mapping
from typing import TypeVar

from roslab.config.model import WORKSPACE_TOOLS, Kind
from roslab.decide.linking_projects import linking
from roslab.decide.ros.workspace import packages_of, ros_versions
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.native.output_folder import PROCESSOR
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

Owner = TypeVar("Owner")
_NAME = pattern(r"[A-Za-z0-9_.+-]+")
_FOLDER = pattern(r"(?:[A-Za-z0-9_.+/-]|\{processor\})+")
_MACHINES = ("x86_64", "aarch64")
"""What CMake calls the processors of linux/amd64 and linux/arm64."""
_ASIDE = (places.vendored, places.test, places.example, places.documentation)
MOST_BESIDE = 16
"""Most projects beside the first that are compiled."""
_TEST = pattern(r"(?:^|[_-])(?:g?tests?|unittests?|bench(?:mark)?s?)(?:[_-]|$)", re.IGNORECASE)

_ROS: Mapping[Kind | None, int] = {"ros1": 1, "ros2": 2}
_SOURCE = pattern(r"\.(?:c|cc|cpp|cxx)$")
_TURNED_ON = pattern(r"-D ?(\w+)(?::\w+)?=(?:ON|TRUE|YES|1)\b", re.IGNORECASE)
_SHORT = 5
"""Names of so many letters, which differ by one of them, are different words."""
_OF_TESTS = pattern(r"g(?:test|mock)|catch2?|doctest|(?:google)?benchmark|unit_?test|boost_unit_test", re.IGNORECASE)
"""Libraries that tests and benchmarks are written with."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Compiled:
    """A program that CMake compiles."""

    name: str
    folder: str
    """``source/…``, relative to the repository's root, or ``build/…``, relative to the build folder."""
    file: str
    line: int


def top_of(evidence: Evidence) -> CMakeProject | None:
    """Return the CMake project that is built where the repository is no ROS package: the one nearest to the root.

    One whose code is elsewhere comes after all others, and one that makes the documentation after those with code.
    """
    tops = [project for project in evidence.cmake if project.top_level and not places.vendored(project.file)]

    def rank(project: CMakeProject) -> tuple[bool, bool, int, str]:
        return project.lacks, places.documentation(project.file), project.file.count("/"), project.file

    return min(tops, key=rank, default=None)


def beside_top(evidence: Evidence) -> tuple[CMakeProject, ...]:
    """Return the projects of C++ in the folders beside that one's: the parts of a course, the chapters of a book.

    One that another finds by its name comes before it.
    """
    top = top_of(evidence)
    folder = _place(top) if top else ""
    found = (p for p in evidence.cmake if p.top_level and p.name and not p.lacks and _place(p) not in {"", folder})
    beside = [p for p in found if folder and posixpath.dirname(_place(p)) == posixpath.dirname(folder)]
    left = [p for p in beside if not any(aside(p.file) for aside in _ASIDE)][:MOST_BESIDE]
    ordered: list[CMakeProject] = []
    while left:
        ready = [p for p in left if not any(names_of(each) & found_by(p) for each in left if each is not p)] or left
        ordered += ready
        left = [p for p in left if p not in ready]
    return tuple(ordered)


def names_of(project: CMakeProject) -> frozenset[str]:
    """Return the names by which others may find a project: its own, which may be a variable's, and its folder's."""
    return frozenset({project.name or "", posixpath.basename(_place(project))}) - {""}


def found_by(project: CMakeProject) -> frozenset[str]:
    """Return the names of what a project finds as packages of CMake."""
    return frozenset(each.name for each in project.dependencies if each.namespace == "cmake")


def compiled(evidence: Evidence) -> tuple[Compiled, ...]:
    """Return the programs of the top-level CMake project and of the folders that it adds, without tests.

    And those of the projects that are compiled once its library is installed.
    Where every program is named like one, the project has no others, and they are none: ``test_pipeline``. Nor is one
    that a page has its reader run by a path.
    """
    top = top_of(evidence)
    if top is None:
        return ()
    found: dict[str, Compiled] = {}
    run = {posixpath.basename(m.value.split(" ")[0]) for m in evidence.mentions if _run_by_path(m)}
    for each in (top, *(project for project, _ in linking(evidence, top))):
        projects = tuple(_inside(evidence, each))
        named = _named_like_tests(projects)
        for project in projects:
            usual, placed = _folder(project, evidence, each), dict(project.placed)
            for name, line in project.executables:
                if _NAME.fullmatch(name) and (named or name in run or not _TEST.search(name)):
                    folder = _whole(placed[name], each) if name in placed else usual
                    folder = folder if each is top or folder.startswith("source") else _in_source(folder, each)
                    found.setdefault(name, Compiled(name=name, folder=folder, file=project.file, line=line))
    return tuple(found.values())


def on_path(evidence: Evidence) -> Iterator[str]:
    """Yield the names of those that CMake or Autotools make, which are found by them."""
    yield from (program.name for program in compiled(evidence))
    yield from (name for made in evidence.makefiles for name in made.installs)


def _in_source(folder: str, project: CMakeProject) -> str:
    """Return the folder of a program that is compiled where its project lies."""
    return posixpath.join("source", _place(project), folder)


def _run_by_path(said: Mention) -> bool:
    return said.topic == "command" and said.source == "readme" and said.value.startswith("./")


def folders_of(programs: Iterable[Compiled], evidence: Evidence) -> tuple[str, ...]:
    """Return the folders of programs, each once; where the processor's name is a part of one, for each platform.

    Those of the programs that a page runs come first: PATH holds no folders without end.
    """
    run = {posixpath.basename(m.value.split(" ")[0]) for m in evidence.mentions if m.topic == "command"}
    ordered = sorted(programs, key=lambda each: each.name not in run)
    found = (each.folder.replace(PROCESSOR, machine) for each in ordered for machine in _MACHINES)
    return tuple(dict.fromkeys(found))


def _named_like_tests(projects: Iterable[CMakeProject]) -> bool:
    """Tell whether all programs are named like tests, and nothing is one: no call, library or option of CMake says it.

    Those of a library that has nothing else to run are made for CTest, with a library of tests, or wait for an option.
    """
    programs = [(project, name) for project in projects for name, _ in project.executables]
    asked = [asked for project in projects for asked in project.dependencies]
    tested = any(project.tests or project.optional for project in projects)
    tested = tested or any(each.role == "test" or _OF_TESTS.match(each.name) for each in asked)
    return not tested and all(_TEST.search(name) for _, name in programs)


def _inside(evidence: Evidence, top: CMakeProject) -> Iterator[CMakeProject]:
    """Yield the CMakeLists.txt of the top-level project and those below it, but no copied and no separate ones."""
    root = _place(top)
    for project in sorted(evidence.cmake, key=lambda p: (p.file.count("/"), p.file)):
        below = not root or _place(project) == root or _place(project).startswith(f"{root}/")
        aside = places.vendored(project.file) or places.test(project.file)
        if below and not aside and (project is top or not project.top_level):
            yield project


def _place(project: CMakeProject) -> str:
    return project.file.rpartition("/")[0]


def _folder(project: CMakeProject, evidence: Evidence, top: CMakeProject) -> str:
    """Return the folder of a project's programs: what the nearest file above sets, else its own in the build."""
    here = _place(project)
    above = [p for p in evidence.cmake if p.programs_in and f"{here}/".startswith(f"{_place(p)}/".lstrip("/"))]
    nearest = max(above, key=lambda p: p.file.count("/"), default=None)
    written = nearest.programs_in if nearest and nearest.programs_in else f"build/{here}".rstrip("/")
    return _whole(written, top)


def _whole(written: str, top: CMakeProject) -> str:
    """Return a folder as ``Compiled`` has it, for one that a CMakeLists.txt gives its programs."""
    root = _place(top)
    side, _, rest = written.partition("/")
    if not _FOLDER.fullmatch(written):
        return "build"
    if side == "top":
        return posixpath.normpath(posixpath.join("source", root, rest))
    if side == "build" and root:
        rest = posixpath.relpath(rest, root) if (rest + "/").startswith(f"{root}/") else rest
    return posixpath.normpath(f"{side}/{rest}")


def in_packages(evidence: Evidence, kind: Kind | None = None) -> dict[str, str]:
    """Return the programs that the CMakeLists.txt of each package compiles; of a name that two packages have, none.

    Nor one that only a build outside of a workspace makes, be it of the image's ROS by its ``kind``.
    """
    outside = {(place.file, place.name) for place in outside_of_packages(evidence, kind)}
    folders = {manifest.file.rpartition("/")[0]: manifest.name for manifest in packages_of(evidence).built}
    found: dict[str, str] = {}
    twice: set[str] = set()
    for project in evidence.cmake:
        package = configured_by(project, folders)
        for name, _ in project.executables if package else ():
            if (project.file, name) not in outside and found.setdefault(name, package or "") != package:
                twice.add(name)
    return {name: package for name, package in found.items() if name not in twice}


def outside_of_packages(evidence: Evidence, kind: Kind | None = None) -> tuple[Compiled, ...]:
    """Return the programs below packages that CMake makes only outside of a workspace of their ROS, or of the image's.

    Those, too, that it makes there only where an option is off with which a page at the root builds the workspace.
    """
    macros = {project.file.rpartition("/")[0]: project.macros for project in evidence.cmake}
    made_for = {m.file.rpartition("/")[0]: m for m in packages_of(evidence).built}
    versions = {folder: ros_versions(m, macros.get(folder, ())) for folder, m in made_for.items()}
    found = []
    on = turned_on(evidence) if any(project.without_options for project in evidence.cmake) else frozenset()
    for project in evidence.cmake:
        outside = {*project.outside, *((name, ros) for name, ros, option in project.without_options if option in on)}
        made = owner(project.file, versions) if outside else None
        made = made & {_ROS[kind]} if made and kind in _ROS else made
        for name, line in project.executables if made else ():
            if all((name, each) in outside for each in made or ()):
                found.append(Compiled(name=name, folder=_place(project), file=project.file, line=line))
    return tuple(found)


def turned_on(evidence: Evidence) -> frozenset[str]:
    """Return the options of CMake that each call of a build tool of ROS turns on, on the pages at the root."""
    tools = (m for m in evidence.mentions if m.topic == "build_tool" and m.value in WORKSPACE_TOOLS)
    calls = [m.text for m in tools if m.source == "readme" and "/" not in m.file and "-D" in m.text]
    return frozenset.intersection(*(frozenset(_TURNED_ON.findall(call)) for call in calls)) if calls else frozenset()


def owner(path: str, folders: Mapping[str, Owner]) -> Owner | None:
    """Return what stands for the package that a file lies in, at any depth."""
    while path:
        path = path.rpartition("/")[0]
        if path in folders:
            return folders[path]
    return None


def configured_by(project: CMakeProject, folders: Mapping[str, Owner]) -> Owner | None:
    """Return what stands for the package whose CMake reads a CMakeLists.txt: its own, or one in a folder that it adds.

    No tool of ROS looks for packages inside of another one, and so for none of their files.
    https://github.com/ros-infrastructure/catkin_pkg (packages.py: find_package_paths), 2026-11-25.
    """
    own = project.added or project.file.rpartition("/")[0] in folders
    return owner(project.file, folders) if own else None


def by_source(name: str, among: Container[str]) -> str:
    """Return the program whose source a page names, ``radar_setup`` of ``radar_setup.cpp``, else the name."""
    stem = _SOURCE.sub("", name)
    return stem if name not in among and stem in among else name


def one_letter_off(name: str, among: Iterable[str]) -> str | None:
    """Return the only one of these names that has a letter more, less or another one: ``test_pipline``, as mistyped."""
    near = [other for other in among if len(name) > _SHORT and _alike(name, other)]
    return near[0] if len(near) == 1 else None


def one_of_several(name: str, among: Iterable[str]) -> str | None:
    """Return the first of two or more names that begin with this one: a fork has ``run_kitti`` and ``run_euroc``."""
    longer = [other for other in among if other.startswith((f"{name}_", f"{name}-")) and not _TEST.search(other)]
    return longer[0] if len(name) > _SHORT and len(longer) > 1 else None


def _alike(name: str, other: str) -> bool:
    """Tell whether two names differ by one letter; what counts differs by a digit: ``stage1``, ``stage2``."""
    start = posixpath.commonprefix((name, other))
    left, right = name[len(start) :], other[len(start) :]
    same = left[1:] == right[1:] or left[1:] == right or left == right[1:]
    return same and not any(char.isdigit() for char in (*left[:1], *right[:1]))


def installed_by_pip(evidence: Evidence) -> frozenset[str]:
    """Return the names of the programs that pip installs with the projects of the tree."""
    return frozenset(
        posixpath.basename(program)
        for project in evidence.python
        if project.installable
        for program in (*dict(project.scripts), *project.script_files)
    )
