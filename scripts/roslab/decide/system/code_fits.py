"""Which Ubuntus the code cannot compile on, whatever a page says."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.decide.programs import top_of
from roslab.decide.ros.by_page import installed_beside
from roslab.decide.ros.workspace import packages_of, ros_versions
from roslab.decide.system.added_projects import added_by
from roslab.decide.system.cmake_version import highest
from roslab.decide.system.page_releases import built_older
from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import OF_ROS2, bounds_of, fits, satisfies
from roslab.knowledge.cuda_gpus import NAME as CUDA
from roslab.knowledge.distros import cmake_of_ubuntu, distro, distros, ubuntus
from roslab.knowledge.libraries import library
from roslab.knowledge.recipes import has_release, stands_beside
from roslab.knowledge.shared_objects import ubuntus_with
from roslab.values.version import Version

WORKFLOWS = ".github/workflows/"
TOO_OLD_FOR_PIP = frozenset({"trusty"})
"""Here pip cannot install a newer CMake: its own version does not know today's wheels.
https://github.com/pypa/manylinux#readme (pip 8.1 is the first)"""


def misfits(evidence: Evidence) -> dict[str, tuple[str, ...]]:
    """Return, for each Ubuntu, what the code asks for and the Ubuntu does not have: ``PCL 1.9``, ``CMake 3.1``.

    What none of them has speaks against none.
    """
    ros, asked = bool(packages_of(evidence).built), tuple(_asked(evidence))
    on_gpu = any("cuda" in project.macros for project in _built(evidence))
    compiled = _compiled_in_workflows(evidence)
    seen = on_gpu or not evidence.cmake  # a CMake project may leave its CUDA out
    limits = [limit for limit in evidence.limits if seen or not limit.cuda]
    limits = [limit for limit in limits if not _disproved(limit, compiled, evidence, ros=ros)]
    linked = tuple(_linked(evidence))
    found: dict[str, dict[str, None]] = {ubuntu: {} for ubuntu in ubuntus().values()}
    for ubuntu, lacks in found.items():
        for limit in limits:
            if (limit.at_least and brought(limit.library, evidence)) or built_older(limit, evidence):
                continue
            if limit.library == CUDA and not on_gpu:
                continue
            if not fits(limit.library, ubuntu, at_least=limit.at_least, below=limit.below, ros=ros):
                wanted = f"{limit.at_least} or newer" if limit.at_least else f"older than {limit.below}"
                lacks[f"{limit.library} {wanted} ({limit.what}, {limit.file}:{limit.line})"] = None
        lacks.update(_unlinkable(linked, ubuntu))
        lacks.update({} if ros else _unpackaged(evidence, ubuntu))
        cmake = cmake_of_ubuntu()[ubuntu]
        if needs_newer_cmake(evidence, ubuntu, cmake):
            lacks[f"CMake {needs_newer_cmake(evidence, ubuntu, cmake)}"] = None
        for name, version, place in asked:
            if not (
                satisfies(name, ubuntu, version, ros=ros) or _compiled(name, evidence) or _built_beside(name, version)
            ):
                lacks[f"{name} {version} ({place})"] = None
    nowhere = set.intersection(*(set(lacks) for lacks in found.values()))
    left = {ubuntu: tuple(lack for lack in lacks if lack not in nowhere) for ubuntu, lacks in found.items()}
    return {ubuntu: lacks for ubuntu, lacks in left.items() if lacks}


def _built_beside(name: str, version: str) -> bool:
    """Tell whether the image can build a release that CMake asks for, whichever one its Ubuntu has."""
    return stands_beside(name.lower()) and has_release(name.lower(), *bounds_of(name, version))


def _unpackaged(evidence: Evidence, ubuntu: str) -> dict[str, None]:
    """Return what CMake requires, and packages of other Ubuntus alone bring; ROS may bring it as its own.

    Not what the tree has or CMake fetches, nor what a page installs beside a source that it adds to apt.
    """
    found: dict[str, None] = {}
    own = {name.lower() for each in evidence.cmake for name in (each.name, *each.configs, *each.brought) if name}
    for d in (d for project in _built(evidence) for d in project.dependencies):
        always = d.namespace == "cmake" and d.required and not (d.condition or d.target)
        required = always and d.strength == "declared" and d.role != "test"
        one, name = library("cmake", d.name, ubuntu) if required else None, d.name.partition(" ")[0].lower()
        if one is None or not one.elsewhere or one.ros or name in own:
            continue
        if not (brought(name, evidence) or installed_beside(name, evidence, called=True)):
            found[f"{d.name} ({d.file}:{d.line})"] = None
    return found


def _unlinkable(linked: Iterable[tuple[str, str]], ubuntu: str) -> dict[str, None]:
    """Return what the libraries of the tree that CMake links need, and an Ubuntu does not have."""
    needed = (each for each in linked if ubuntu not in ubuntus_with(each[0]))
    return {f"{package} ({file}, which is linked, needs it)": None for package, file in needed}


def _linked(evidence: Evidence) -> Iterator[tuple[str, str]]:
    """Yield the packages of known Ubuntus alone that libraries of the tree need which CMake links, each with the file.

    One that the repository builds from source may have any version.
    """
    folders = {project.file for project in _built(evidence)}
    linked = {each.what for each in evidence.x86_only if each.source == "binary" and each.file in folders}
    for each in evidence.code if linked else ():
        known = each.role == "linked" and each.file in linked and ubuntus_with(each.name)
        if known and not brought(each.name.removeprefix("lib").partition("-")[0], evidence):
            yield each.name, each.file


def _compiled_in_workflows(evidence: Evidence) -> tuple[str, ...]:
    """Return the Ubuntus that workflows on GitHub name which call CMake."""
    own = [m for m in evidence.mentions if m.source == "ci" and m.file.startswith(WORKFLOWS)]
    compile_ = {m.file for m in own if m.topic == "build_tool" and m.value == "cmake"}
    named = (ubuntus().get(m.value, m.value) for m in own if m.topic == "ubuntu" and m.file in compile_)
    return tuple(name for name in named if name in ubuntus().values())


def _disproved(limit: CodeLimit, compiled: tuple[str, ...], evidence: Evidence, *, ros: bool) -> bool:
    """Tell whether a workflow compiles beside a newer library than a sign in the code allows.

    That code is then behind an option. A library that is too old is disproved by none: a workflow may be older than the
    code.
    """
    if limit.below is None or brought(limit.library, evidence):
        return False
    return any(not fits(limit.library, name, at_least=None, below=limit.below, ros=ros) for name in compiled)


def brought(library: str, evidence: Evidence) -> bool:
    """Tell whether the repository builds a library from its source, in a version that no Ubuntu may have."""
    name = library.lower().rstrip("3")
    return any(git.kind != "link" and git.name.lower().startswith(name) for git in evidence.sources)


def _compiled(library: str, evidence: Evidence) -> bool:
    """Tell whether a page or a script compiles and installs a library at a fixed release."""
    names = {library.lower(), library.lower().rstrip("3")}
    return any(git.installed and git.ref and git.name.lower() in names for git in evidence.sources)


def unlaunchable(evidence: Evidence) -> dict[str, frozenset[str]]:
    """Return, for each distribution of ROS 2, what launch files have that it does not know: ``executable=``."""
    return _unknown_to(limit for limit in evidence.limits if limit.library == "launch_ros")


def unincluded(evidence: Evidence) -> dict[str, frozenset[str]]:
    """Return, for each distribution of ROS 2, what the code includes, imports or calls of ROS and that it lacks."""
    of_ros2 = (limit for limit in evidence.limits if limit.library.startswith(OF_ROS2))
    return _unknown_to(limit for limit in of_ros2 if _of_apt(limit, evidence))


def _unknown_to(limits: Iterable[CodeLimit]) -> dict[str, frozenset[str]]:
    """Return, for each distribution of ROS 2, what it does not have; some names were away for a while."""
    found: dict[str, frozenset[str]] = {}
    for limit in limits:
        oldest, first_without = distro(limit.at_least or ""), distro(limit.below or "")
        for name, release in distros().items():
            old = oldest is not None and not release.never_ends and release.released < oldest.released
            newer = first_without is not None and release.released >= first_without.released
            new = newer or (first_without is not None and release.never_ends)
            away = oldest and first_without and first_without.released < oldest.released
            if release.ros == 2 and ((old and new) if away else (old or new)):
                found[name] = found.get(name, frozenset()) | {limit.what}
    return found


def _of_apt(limit: CodeLimit, evidence: Evidence) -> bool:
    """Tell whether a header of ROS is the distribution's: no source brings its repository, and no ROS 1 includes it."""
    repository = limit.library.removeprefix(OF_ROS2)
    cloned = {git.name.rpartition("/")[2] for git in evidence.sources if git.kind != "link"}
    return repository not in cloned and not _of_ros1(limit.file, evidence)


def _of_ros1(file: str, evidence: Evidence) -> bool:
    """Tell whether a file is in a package of ROS 1 alone, whose headers have the same names."""
    above = [(m.file.rpartition("/")[0], m) for m in evidence.manifests]
    holding = [(folder, m) for folder, m in above if not folder or file.startswith(f"{folder}/")]
    if not holding:
        return False
    folder, manifest = max(holding, key=lambda each: len(each[0]))
    macros = (project.macros for project in evidence.cmake if project.file.rpartition("/")[0] == folder)
    return 2 not in ros_versions(manifest, next(macros, ()))


def _asked(evidence: Evidence) -> Iterator[tuple[str, str, str]]:
    """Yield name, version and place of what the projects that are built require at a version.

    Not a release that a linked target alone tells and that the image can build on any Ubuntu.
    """
    for project in _built(evidence):
        for d in project.dependencies:
            tabled = d.target and has_release(d.name.lower(), d.version or "0", None)
            if d.namespace == "cmake" and d.strength == "declared" and d.version and d.role != "test" and not tabled:
                yield d.name, d.version, f"{d.file}:{d.line}"


def _built(evidence: Evidence) -> Iterator[CMakeProject]:
    folders = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    top = top_of(evidence)
    for project in evidence.cmake:
        aside = places.aside(project.file)
        if not aside and (project.file.rpartition("/")[0] in folders or (not folders and project is top)):
            yield project


def needs_newer_cmake(evidence: Evidence, ubuntu: str, cmake: str) -> str | None:
    """Return the CMake that a project asks for, if neither the Ubuntu nor pip on it has one."""
    if ubuntu not in TOO_OLD_FOR_PIP:
        return None
    built = tuple(_built(evidence))
    asked = highest(built, added_by(built, evidence.cmake, usual=True).projects)
    newest = asked.version if asked else None
    return newest if newest and Version(newest) > Version(cmake) else None
