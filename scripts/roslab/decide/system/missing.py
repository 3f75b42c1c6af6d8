"""Packages that CMake requires and that nothing in the image will have: what the build does about them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from roslab.config.model import WORKSPACE_TOOLS, BuildTool, Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.downloads import names_at_home
from roslab.decide.reasons import because, warn
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.included import without_headers
from roslab.decide.ros.nothing_to_build import nothing_to_build
from roslab.decide.ros.nowhere import without_own
from roslab.decide.ros.outside import outside
from roslab.decide.ros.part_builds import builds, to_whole
from roslab.decide.ros.rosbuild import ended_in
from roslab.decide.ros.skip_packages import skip_packages
from roslab.decide.ros.skipped import skipped
from roslab.decide.ros.source_names import address, plain
from roslab.decide.ros.without_code import without_code
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.built import Built
from roslab.decide.system.by_hand import of_majors
from roslab.decide.system.guards import required_by_tool
from roslab.decide.system.left_out import SKIP, folders_of, leave_out, with_modules
from roslab.decide.system.library_headers import without_library
from roslab.decide.system.lost_extensions import lost_extensions, may_stop, told
from roslab.decide.system.lost_parts import lost_parts
from roslab.decide.system.names import Target, resolve, written_for
from roslab.decide.system.no_config import told_configs, without_config
from roslab.decide.system.not_found import not_found
from roslab.decide.system.other_than_carried import other_than_carried
from roslab.decide.system.packages import SystemPackages
from roslab.decide.system.required import (
    of_program,
    of_program_and_below,
    other_letters,
    provided_as,
    required,
    similar,
    undeclared,
)
from roslab.decide.system.strays import strays
from roslab.decide.system.switches import given, switch_of, switched_off
from roslab.decide.system.tests_left_out import of_package_tests, of_tests
from roslab.decide.system.too_old import too_old
from roslab.decide.system.tried_headers import without_tried
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.recipes import brings
from roslab.knowledge.released import released, rosdep_keys
from roslab.values.dataclass import dataclass, replace
from roslab.values.requirement import Requirement
from roslab.values.words import line_of

_PERHAPS = (
    "CMake requires {}, which no package.xml asks for and no table knows: one of the cloned repositories may hold it; "
    "else give its repository under `source` in roslab.yaml"
)
_OFF = (
    "nothing is known that brings {}: it is built without it, with -D{}=OFF; give its repository under `source` in "
    "roslab.yaml to have it, and set the option in `cmake_options`"
)
_TESTS = (
    "only the tests ask for {}, which is not installed: they are not compiled, with -D{}=OFF; give `cmake_options` in "
    "roslab.yaml to have them"
)
_UNDECLARED = (
    "CMake of {0} requires {1}, which its package.xml does not name: it is named there in the image, or {1} might be "
    "built too late; add <depend>{1}</depend>"
)
_BESIDE = "outside of the workspace that the page builds: it goes without where it does not compile"
ENDED = 300
"""Weight of the reasons for what is taken out of a manifest; nothing competes with them."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Missing:
    """What is left out of the build because nothing brings it."""

    packages: tuple[str, ...] = ()
    """Packages of the repository that are not built."""
    lacking: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """What a clone may bring, each with the folders of the packages that are not built where none does."""
    stops: tuple[str, ...] = ()
    """What the build stops without."""
    ended: tuple[str, ...] = ()
    """Packages that the manifests of rosbuild are told not to need."""
    options: tuple[str, ...] = ()
    """What turns those options of CMake off that are on and ask for a package which nothing brings."""
    tests: tuple[str, ...] = ()
    """Those of the options that are for the tests."""
    stopping: tuple[str, ...] = ()
    """Files of CMake that look for a library or a program, or link one, which nothing brings, and files of code that
    include one; and manifests of packages outside of the workspace that the page builds."""
    extensions: tuple[str, ...] = ()
    """Folders of projects of Python whose extension requires what nothing brings: pip stops there."""
    strays: tuple[str, ...] = ()
    """Folders of CMake projects without a package.xml that lack something, and that nothing of the tree needs."""
    unsure: tuple[str, ...] = ()
    """What CMake requires, no package.xml asks for, and one of the clones may bring."""
    undeclared: bool = False
    """A package requires another one of the repository, and its package.xml does not name it."""


def decide_missing(
    evidence: Evidence,
    kind: Kind,
    build_tool: BuildTool,
    *,
    target: Target,
    packages: Packages,
    provided: Iterable[str],
    built: Iterable[str],
    keys: Iterable[str] = (),
    command: tuple[str, ...] | str,
    switch: bool = False,
    cloned: bool = False,
    may_hold: Callable[[str], bool] = lambda _: False,
    tried: Mapping[str, str] | None = None,
    config: Config,
) -> Choice[Missing]:
    """Return the packages to leave out of the build because of what they lack, with those that need these.

    ``provided``: names of everything that is installed, built or cloned; a similar one is taken for the package.
    ``built``: names of what is built from its source; other clones bring no newer version of anything.
    ``keys``: what rosdep is asked for, of which only what its tables or the distribution have is provided.
    ``switch``: options of CMake may be turned off that a page does not set.
    ``cloned``: the image clones packages whose names are not known here; ``may_hold``: whether one of them may be of a
    name. What cannot be left out is told, for there the build stops. ``tried``: where the build looks for packages
    that nothing brings: what needs these is left out only in the image, where none holds them. Commands of ``config``
    may bring anything.
    """
    custom, started = config.custom is not None, line_of(command).split()
    by_hand, said_by_hand = skip_packages(config, packages, build_tool, started)
    if kind not in {"ros1", "ros2", "cpp"}:
        lost = tuple(lost_extensions(evidence, packages, target, provided, unread=custom or cloned))
        return Choice(
            answer=Missing(extensions=may_stop(lost, evidence, command)),
            warnings=(*said_by_hand, *told(lost, evidence, command)),
        )
    evidence = required_by_tool(evidence, kind)
    known = released(target.ros_distro or "") | rosdep_keys()
    provided = (*provided, *(key for key in keys if key in known or kind == "cpp"))
    ended = ended_in(packages, target.ros_distro, provided)
    names, made = {plain(name) for name in provided}, {plain(name) for name in built}
    named = known | packages.names
    sure = named | {*provided}
    unsure = {m.name for m in packages.built if any(_of_a_clone(d, sure) and may_hold(d.name) for d in m.dependencies)}
    unmet = [
        (package, asked)
        for package, asked in (of_program(evidence, packages) if kind == "cpp" else _on(evidence, packages, build_tool))
        if without_config(asked, kind)
        or (
            not ((asked.namespace == "ros" and may_hold(asked.name)) or package in unsure)
            and not (resolve(asked, target).known or provided_as(asked.name, names))
        )
    ]
    options = given(evidence) if switch else ""
    off = {switch_of(asked, options): asked for _, asked in unmet if switch and switch_of(asked, options)}
    lacking: dict[tuple[str, str], Dependency] = {}
    for package, asked in unmet:
        if switch_of(asked, options) not in off:
            lacking.setdefault((package, asked.name), asked)
    tests = of_tests(evidence, target, packages, names) if switch else {}
    tests |= of_package_tests(evidence, target, packages, names, may_hold) if build_tool == "colcon" else {}
    keyed = {d.name for manifest in packages.built for d in manifest.dependencies}  # these are told as keys
    unsure_of = [
        asked
        for package, asked in _on(evidence, packages, build_tool)
        if (asked.namespace == "ros" and may_hold(asked.name)) or package in unsure
        if asked.name not in keyed and not resolve(asked, target).known
        if not similar(plain(asked.name), names)
    ]
    left, codeless = without_code(
        evidence,
        packages,
        build_tool,
        started=started,
        left={**(skipped(evidence, packages, build_tool, started) if build_tool in SKIP else {}), **by_hand},
    )
    alike, tried = other_letters(evidence, packages), with_modules(tried or {}, unmet, build_tool)
    found = leave_out(lacking, packages, build_tool, started=started, left=left, tried=tried, alike=alike)
    warnings = [*said_by_hand, *codeless, *told_configs(found.warnings, unmet, kind)]
    first = {asked.name: asked for asked in reversed(unsure_of)}
    warnings += [warn(_PERHAPS.format(name), first[name]) for name in dict.fromkeys(d.name for d in unsure_of)]
    warnings += [warn(_OFF.format(asked.name, option), asked) for option, asked in off.items()]
    warnings += [warn(_TESTS.format(asked.name, option), asked) for option, asked in tests.items()]
    still = replace(packages, built=tuple(m for m in packages.built if m.name not in found.packages))
    if kind != "cpp":
        there = names | known | {asked.name for _, asked in unmet}
        warnings += without_headers(evidence, still, there, tried, build_tool=build_tool, cloned=cloned)
        warnings += without_own(evidence, still, lambda name: plain(name) in names, build_tool)
    warnings += other_than_carried(evidence, packages, target, made)
    warnings += without_tried(evidence, packages, target, provided, build_tool)
    aside = dict(strays(evidence, packages, target, names, build_tool) if not (cloned or custom) else ())
    warnings += aside.values()
    of_build = Built(target=target, names=names, build_tool=build_tool, kind=kind, out=found.packages)
    unfound = (
        *without_library(evidence, still, names, build_tool, unread=cloned or custom),
        *not_found(evidence, packages, target, names, build_tool, built=made, tried=tried),
        *(() if custom else lost_parts(evidence, packages, of_build, may_hold, tried)),
    )
    warnings += [warning for _, warning in unfound]
    hidden = {
        f"{package} {asked.name}": (package, asked) for package, asked in undeclared(evidence, packages, build_tool)
    }
    warnings += [warn(_UNDECLARED.format(package, asked.name), asked) for package, asked in hidden.values()]
    asks = of_program_and_below if kind == "cpp" else required
    names -= {plain(git.name) for git in evidence.sources if git.kind == "clone"} - made
    warnings += too_old(asks(evidence, packages), target, found.packages, names, build_tool)
    beside = tuple(outside(evidence, packages, command)) if kind != "cpp" else ()
    why = f"ROS {target.ros_distro} has no package of that name: it is taken out of the manifests in the image"
    return Choice(
        answer=Missing(
            packages=found.packages,
            lacking=found.lacking,
            stops=found.stops,
            ended=tuple(ended),
            options=tuple(f"-D{name}=OFF" for name in (*off, *tests)),
            tests=tuple(tests),
            strays=tuple(sorted(aside)),
            unsure=tuple(dict.fromkeys(asked.name for asked in unsure_of)),
            undeclared=bool(hidden),
            stopping=tuple(dict.fromkeys((*(file for file, _ in unfound if file), *(m.file for m, _ in beside)))),
        ),
        warnings=tuple(warnings),
        reasons=(
            *(because("dependencies", name, why, asked, weight=ENDED) for name, asked in ended.items()),
            *(because("workspace", name, said.why, said.place, weight=ENDED) for name, said in left.items()),
            *(because("workspace", m.name or "", _BESIDE, said, weight=ENDED) for m, said in beside),
        ),
    )


def _on(evidence: Evidence, packages: Packages, build_tool: BuildTool) -> Iterator[tuple[str, Dependency]]:
    """Yield each package with what it requires, but for what an option turns off with which a page builds it."""
    said = " ".join(call.text for call in to_whole(builds(evidence, build_tool)))
    yield from (each for each in required(evidence, packages) if not switched_off(each[1], said))


def provided(
    evidence: Evidence, system: SystemPackages, sources: Sources, installed: Iterable[Requirement], target: Target
) -> Iterator[str]:
    """Yield the names of everything that is installed, built or cloned; ``installed`` is what pip and conda bring.

    Not packages of ROS that an install line has for another distribution, and that this one never released, nor a clone
    that was read and that the image does not have.
    """
    said = {each.name for each in evidence.prose}
    guessed = (*system.apt, *system.apt_guessed, *system.brought)
    yield from (name for name in guessed if name in said or _there(name, target))
    yield from (*sources.names, *(source.name for source in (*sources.sources, *sources.submodules)))
    planned = {address(source.repo or "") for source in sources.everything}
    yield from (
        git.name for git in evidence.sources if git.kind not in {"link", "clone"} or address(git.url) in planned
    )
    yield from (name for name in said if written_for(name) == target.ros_distro or _there(name, target))
    yield from (each.key for each in installed if each.name)
    yield from names_at_home(evidence)
    yield from of_majors(evidence, sources.sources)
    yield from (name for source in sources.sources for name in brings(source.name))


def _there(name: str, target: Target) -> bool:
    """Tell whether the image can have a package: of one of ROS, whether its distribution released it."""
    return written_for(name) is None or target.knows(name.split("-", 2)[-1].replace("-", "_").rstrip("*_"))


def _of_a_clone(asked: Dependency, known: frozenset[str]) -> bool:
    """Tell whether a key may be a cloned package's, which CMake may find by a name of its own."""
    return asked.namespace == "rosdep" and asked.role not in {"test", "doc"} and asked.name not in known


def marked(build_tool: BuildTool, missing: Missing, packages: Packages, evidence: Evidence) -> tuple[str, ...]:
    """Return the folders that a build tool of ROS must not look into; others look at no packages."""
    if build_tool not in {*WORKSPACE_TOOLS, "rosmake"}:
        return ()
    folders = folders_of(packages, missing.packages) if SKIP.get(build_tool) == "" else ()
    empty = nothing_to_build(evidence, packages, build_tool)
    return tuple(dict.fromkeys((*packages.doubles, *folders, *empty, *missing.strays)))


def skipping(build_tool: BuildTool, packages: tuple[str, ...]) -> tuple[str, ...]:
    """Return the arguments with which a build tool leaves packages out."""
    option = SKIP.get(build_tool)
    if not packages or not option:
        return ()
    return (option + ";".join(packages),) if option.endswith("=") else (option, *packages)
