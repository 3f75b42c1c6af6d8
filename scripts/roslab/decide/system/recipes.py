"""Libraries that no package of the Ubuntu contains, as sources to build."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Iterator

from roslab.config.model import Source
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.ros.source_names import itself_in, plain
from roslab.decide.system.names import Target
from roslab.decide.system.page_releases import built_older
from roslab.decide.system.shown_headers import headers_by_name, shown_by
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import bounds_of, fits, satisfies
from roslab.knowledge.libraries import library
from roslab.knowledge.recipes import Bound, Recipe, has_release, recipe, releases
from roslab.values.version import Version


def recipes_for(
    wanted: Iterable[tuple[str, Dependency]],
    ubuntu: str | None,
    limits: Iterable[CodeLimit],
    own: frozenset[str],
    day: str | None = None,
) -> tuple[tuple[Source, Dependency], ...]:
    """Return the sources of libraries, each once with what asked for it, in the order to build them.

    ``limits`` are the signs of versions in the code, which choose the release; ``own`` are names of the repository
    itself, which is none of them, though what it needs is;
    ``day``: that of the work, where it is old.
    """
    bounds: dict[str, tuple[Bound, ...]] = {}
    for limit in limits:
        name = limit.library.lower()
        bounds[name] = (*bounds.get(name, ()), (limit.at_least, limit.below))
    found: dict[str, tuple[Source, Dependency]] = {}
    for name, dependency in wanted:
        for built in recipe(name, ubuntu, bounds, day):
            if plain(built.name) not in own:
                found.setdefault(built.name, (_source(built), dependency))
    return tuple(found.values())


def own_names(evidence: Evidence, folder_name: str) -> frozenset[str]:
    """Return the names of the repository itself as a library, for which its own examples may ask."""
    named = {plain(each.name) for each in evidence.cmake if each.file == "CMakeLists.txt" and each.name}
    return frozenset({plain(folder_name), *named})


def required_releases(needed: Iterable[tuple[Dependency, bool]]) -> Iterator[CodeLimit]:
    """Yield what CMake requires at a version, in what is built, as bounds on the release to build."""
    for asked, trusted in needed:
        if trusted and asked.namespace == "cmake" and asked.strength == "declared" and asked.version:
            oldest, first_not = bounds_of(asked.name, asked.version)
            what = f"the target {asked.target}" if asked.target else f"find_package({asked.name} {asked.version})"
            yield CodeLimit(
                library=asked.name, at_least=oldest, below=first_not, what=what, file=asked.file, line=asked.line
            )


def _source(built: Recipe) -> Source:
    if built.archives:
        amd64, arm64 = built.archives
        lines = shlex.join(("printf", "%s\\n", *built.installs.strip().split("\n")))
        return Source(name=built.name, zip=amd64, zip_arm64=arm64, prepare=f"{lines} > CMakeLists.txt")
    return Source(
        name=built.name,
        repo=built.repo,
        ref=built.ref,
        depends=built.depends,
        build="cmake",
        cmake_options=" ".join(built.options),
        cmake_folder=f"../{built.cmake_in}" if built.cmake_in else built.makefile_in,
        make_command=built.make,
        tabled=built.makefile_in is None,
        by_make=built.makefile_in is not None,
    )


def linked(
    needed: Iterable[tuple[Dependency, bool]], evidence: Evidence, ubuntu: str | None
) -> Iterator[tuple[str, Dependency]]:
    """Yield the libraries without a package that are linked and that a page or a script of the repository clones.

    And those that are linked by a file below /usr/local, where no package of Ubuntu puts its own.
    A name that is only linked may be a library that is compiled beside it: the clone tells, where it is not one of the
    repository itself. What installs no package of CMake can only be linked, and what archives bring is unpacked:
    nothing else is called so where the tree and its submodules do not make it. A header of the same name that the tree
    lacks tells, too. ``needed`` are names, each with whether it may be taken for more than a guess.
    """
    names = (*(manifest.name for manifest in evidence.manifests), *(each.name for each in evidence.cmake))
    own = {name for name in names if name}
    cloned = {plain(git.name) for git in evidence.sources if git.kind == "clone" and not itself_in(git, own)}
    made = {name for project in evidence.cmake for name in project.made}
    unread = any(git.kind == "submodule" and git.absent for git in evidence.sources)
    headers = headers_by_name(evidence)
    for dependency, trusted in needed:
        if trusted and _by_file(dependency) and recipe(dependency.name, ubuntu):
            yield dependency.name, dependency
        shown = bool(shown_by(dependency, headers))
        if not (trusted or shown) or dependency.namespace != "link" or library("link", dependency.name, ubuntu):
            continue
        found = library("cmake", dependency.name, ubuntu)
        if not (found and found.recipe) or found.apt:
            continue
        only = shown or any(built.makefile_in or built.archives for built in recipe(found.recipe, ubuntu))
        if plain(found.recipe) in cloned or (only and not unread and dependency.name not in made):
            yield found.recipe, dependency


def lies_elsewhere(
    needed: Iterable[tuple[Dependency, bool]], evidence: Evidence, ubuntu: str | None
) -> Iterator[Warning_]:
    """Yield what the author should know of a library that is linked by a file below /usr/local, and that apt brings.

    Also of one that a setup.py links so and that no table knows: pip stops there.
    """
    built = {plain(git.name) for git in evidence.sources if git.installed}
    for dependency, trusted in needed:
        name = dependency.name
        if not (trusted and _by_file(dependency)) or recipe(name, ubuntu) or plain(name) in built:
            continue
        found = library("link", name, ubuntu)
        apt = " ".join(found.apt) if found else ""
        if apt or dependency.role == "setup":
            why = f"{apt} puts it elsewhere" if apt else "nothing is known to put it there"
            message = f"lib{name} is linked by its file in /usr/local, and {why}"
            yield warn(f"{message}: the build stops there; link it by its name, {name}", dependency)


def _by_file(dependency: Dependency) -> bool:
    """Tell whether a call names a library by its file below /usr/local: no other name of the linker is declared."""
    return dependency.namespace == "link" and dependency.strength == "declared"


def of_another_release(evidence: Evidence, apt: Iterable[str]) -> tuple[tuple[str, Dependency], ...]:
    """Return the libraries that a package of ROS would bring in a release that the code does not compile with.

    Which one it brings no table says: of those that changed, ROS has the newer.
    """
    brought = {name.partition("-")[2].partition("-")[2] for name in apt if name.startswith("ros-")}
    return tuple(
        (name, Dependency(namespace="include", name=limit.what, strength="used", file=limit.file, line=limit.line))
        for limit in evidence.limits
        if limit.below and not limit.cuda and (name := limit.library.lower()) in brought and recipe(name, None)
    )


def refused_here(required: Iterable[CodeLimit], target: Target) -> Iterator[tuple[str, Dependency]]:
    """Yield the libraries that CMake requires in a release which this Ubuntu does not have, and which a recipe has."""
    for limit in required:
        name, oldest = limit.library.lower(), limit.at_least or "0"
        fit = has_release(name, oldest, limit.below)
        if fit and target.ubuntu and not satisfies(limit.library, target.ubuntu, oldest, ros=bool(target.ros_distro)):
            asked = Dependency(
                namespace="cmake", name=limit.what, strength="declared", file=limit.file, line=limit.line
            )
            yield name, asked


def too_new_here(evidence: Evidence, target: Target) -> Iterator[tuple[str, Dependency]]:
    """Yield the libraries of which this Ubuntu has a newer release than the code compiles with, and a page an older."""
    ubuntu, ros = target.ubuntu, bool(target.ros_distro)
    for limit in evidence.limits if ubuntu else ():
        built = not limit.cuda and built_older(limit, evidence)
        if built and not fits(limit.library, ubuntu or "", at_least=None, below=limit.below, ros=ros):
            asked = Dependency(namespace="include", name=limit.what, strength="used", file=limit.file, line=limit.line)
            yield limit.library.lower(), asked


def too_old_here(evidence: Evidence, apt: Iterable[str], target: Target) -> tuple[tuple[str, Dependency], ...]:
    """Return the libraries whose package is older on this Ubuntu than the code needs, and that a recipe has newer.

    ROS may have a package of its own: of g2o the one of 2020.
    """
    installed, ubuntu = frozenset(apt), target.ubuntu
    found: dict[str, Dependency] = {}
    for limit in evidence.limits:
        name, oldest = limit.library.lower(), limit.at_least
        packaged = library("cmake", limit.library, ubuntu)
        there = {*packaged.apt, target.ros(packaged.ros)} if packaged else set[str]()
        if limit.cuda or not (oldest and ubuntu and installed & there):
            continue
        newer = any(Version(release) >= Version(oldest) for release in releases(name))
        if newer and not fits(limit.library, ubuntu, at_least=oldest, below=None, ros=bool(target.ros_distro)):
            found[name] = Dependency(
                namespace="include", name=limit.what, strength="used", file=limit.file, line=limit.line
            )
    return tuple(found.items())
