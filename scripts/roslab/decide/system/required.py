"""What CMake requires of others, for each package of a workspace, a program, or what pip compiles."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.config.model import BuildTool, Kind
from roslab.decide.programs import top_of
from roslab.decide.ros.own_configs import installing
from roslab.decide.ros.source_names import SHORTEST, plain
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.bare_names import bare, without_major
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.evidence.python_project import PythonProject


def required(evidence: Evidence, packages: Packages) -> Iterator[tuple[str, Dependency]]:
    """Yield each package with what its own CMakeLists.txt, and those it always adds, require and no file here finds."""
    lacking = Outside(evidence, packages)
    for package, project in _of_packages(evidence, packages):
        yield from ((package, asked) for asked in lacking.of(project))


def _of_packages(evidence: Evidence, packages: Packages) -> Iterator[tuple[str, CMakeProject]]:
    """Yield each package with its own CMakeLists.txt and those it always adds."""
    named = {manifest.file.rpartition("/")[0]: manifest.name for manifest in packages.built}
    for project in evidence.cmake:
        folder = project.file.rpartition("/")[0]
        while project.always and folder and folder not in named:
            folder = folder.rpartition("/")[0]
        if package := named.get(folder):
            yield package, project


def asking(evidence: Evidence, packages: Packages, libraries: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """Return the packages whose CMake asks for each of some libraries, by the library's name."""
    names = {bare(name): name for name in libraries}
    found: dict[str, dict[str, None]] = {}
    for package, project in _of_packages(evidence, packages) if names else ():
        asked = {bare(each.name) for each in project.dependencies}
        for name in {*asked, *without_major(asked).values()} & names.keys():
            found.setdefault(names[name], {})[package] = None
    return {name: tuple(by) for name, by in found.items()}


def programs(evidence: Evidence, packages: Packages, kind: Kind) -> Iterator[tuple[str, Dependency]]:
    """Yield each package, or the program, with the programs without which its CMakeLists.txt and those below stop.

    Not what a target of the tree makes.
    """
    made = {name for project in evidence.cmake for name, _ in project.executables}
    for name, project in reached(evidence, packages, kind):
        yield from ((name, asked) for asked in project.programs if asked.role != "test" and asked.name not in made)


def reached(evidence: Evidence, packages: Packages, kind: Kind) -> Iterator[tuple[str, CMakeProject]]:
    """Yield each package, or the program, with the CMakeLists.txt files that its build always comes to."""
    if kind in {"ros1", "ros2"}:
        yield from _of_packages(evidence, packages)
    elif kind == "cpp":
        yield from _of_top(evidence)


def _of_top(evidence: Evidence) -> Iterator[tuple[str, CMakeProject]]:
    """Yield the program with the CMakeLists.txt at its top and those that it always adds."""
    top = top_of(evidence)
    for project in evidence.cmake if top else ():
        if project is top or (project.always and not (places.vendored(project.file) or places.test(project.file))):
            yield top.name or "the program" if top else "", project


def undeclared(evidence: Evidence, packages: Packages, build_tool: BuildTool) -> Iterator[tuple[str, Dependency]]:
    """Yield each package with what its CMakeLists.txt requires of the other packages and its package.xml does not name.

    Build tools order packages by their package.xml alone: CMake may look for one that is not there yet. A project of
    CMake without such a file is a package of its name to colcon (https://github.com/colcon/colcon-cmake, 2026-11-27).
    """
    by_folder = {manifest.file.rpartition("/")[0]: manifest for manifest in packages.built}
    names = {manifest.name for manifest in packages.built}
    if build_tool == "colcon":
        names |= {top.name for name, top in installing(evidence).items() if name == (top.name or "").lower()}
    for project in evidence.cmake:
        manifest = by_folder.get(project.file.rpartition("/")[0])
        if manifest is None or manifest.name is None:
            continue
        named: set[str | None] = {manifest.name, *(each.name for each in manifest.dependencies)}
        for asked in project.dependencies:
            if _to_build(asked) and asked.name in names - named:
                yield manifest.name, asked


def of_program(evidence: Evidence, packages: Packages) -> Iterator[tuple[str, Dependency]]:
    """Yield the program with what the CMakeLists.txt at its top requires and no file of the tree finds."""
    if top := top_of(evidence):
        yield from ((top.name or "the program", asked) for asked in Outside(evidence, packages).of(top))


def of_program_and_below(evidence: Evidence, packages: Packages) -> Iterator[tuple[str, Dependency]]:
    """Yield the program with what its CMakeLists.txt and those of the folders that it adds require."""
    top = top_of(evidence)
    lacking = Outside(evidence, packages)
    for project in evidence.cmake if top else ():
        if project is top or not (project.top_level or places.vendored(project.file) or places.test(project.file)):
            yield from ((top.name or "the program", asked) for asked in lacking.of(project) if top)


def own_names(evidence: Evidence, packages: Packages) -> AbstractSet[str | None]:
    """Return the names of what the tree itself has: packages, projects and modules of CMake."""
    return packages.names | {each.name for each in evidence.cmake} | evidence.cmake_modules


def in_any_letters(evidence: Evidence) -> AbstractSet[str]:
    """Return the names, in small letters, of projects of CMake that others may find by that name in any letters.

    CMake looks for ``FOOConfig.cmake`` and for ``foo-config.cmake``
    (https://cmake.org/cmake/help/latest/command/find_package.html#config-mode-search-procedure, read 2026-11-27); where
    a project installs neither, what makes it known is not seen here. Packages of ROS are found by their letters.
    """
    of_ros = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests}
    plainly = [project for project in evidence.cmake if project.file.rpartition("/")[0] not in of_ros]
    installed = {name for project in evidence.cmake for name in project.configs}
    capital = {name.lower() for name in installed if not name.islower()}
    names = {project.name.lower() for project in plainly if project.name} - capital
    return names | {name for name in installed if name.islower()}


def other_letters(evidence: Evidence, packages: Packages) -> dict[str, str]:
    """Return, by their names in small letters, the packages of the tree and what its projects install for CMake."""
    names = (*packages.names, *(each for project in evidence.cmake for each in project.configs))
    return {name.lower(): name for name in names if name}


class Outside:
    """What projects of CMake require and the tree does not have, but for tests."""

    def __init__(self, evidence: Evidence, packages: Packages) -> None:
        self._own, self._others = own_names(evidence, packages), in_any_letters(evidence)

    def of(self, project: CMakeProject) -> Iterator[Dependency]:
        """Yield what one of them requires."""
        for asked in project.dependencies:
            here = asked.name in self._own or (_by_cmake(asked) and asked.name.lower() in self._others)
            if _to_build(asked) and not here:
                yield asked


def _by_cmake(asked: Dependency) -> bool:
    return asked.namespace == "cmake"


def _to_build(asked: Dependency) -> bool:
    """Tell whether CMake stops without it, whether or not the tests are built."""
    return asked.namespace in {"cmake", "ros"} and asked.strength == "declared" and asked.role != "test"


def similar(wanted: str, names: Iterable[str]) -> bool:
    """Tell whether a name is another's, or a part of it; ``pycolmap`` only calls ``colmap``."""
    return any(wanted in name.replace(f"py{wanted}", "") for name in names)


def provided_as(name: str, names: Collection[str]) -> bool:
    """Tell whether something is called like a name of CMake, or like another name of that library."""
    from roslab.knowledge.other_names import other_names  # noqa: PLC0415 - few projects require more

    others = (plain(other) for other in other_names(name))
    return similar(plain(name), names) or any(len(other) >= SHORTEST and similar(other, names) for other in others)


def by_pip(evidence: Evidence, packages: Packages) -> Iterator[tuple[PythonProject, Dependency]]:
    """Yield each project of Python whose setup.py calls CMake with what the CMakeLists.txt beside it requires."""
    lacking = Outside(evidence, packages)
    for project in evidence.python:
        if project.installable and "cmake" in project.extensions and not places.aside(project.file):
            for made in (each for each in evidence.cmake if each.file.rpartition("/")[0] == project.folder):
                yield from ((project, asked) for asked in lacking.of(made))
