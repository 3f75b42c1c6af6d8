"""System packages: declared ones, which must install, and guessed ones, installed if apt has them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import because, configured
from roslab.decide.ros.by_page import by_page
from roslab.decide.ros.controllers import controllers, of_controller
from roslab.decide.ros.keys import (
    Translated,
    declared_keys,
    of_an_apt_source,
    own_packages,
    together,
    translate,
)
from roslab.decide.ros.own_targets import own_targets
from roslab.decide.ros.source_names import address
from roslab.decide.ros.workspace import Packages
from roslab.decide.system.asked_how import how_asked
from roslab.decide.system.by_pip import imported_from_pip, only_imported
from roslab.decide.system.carried import brought, held
from roslab.decide.system.companions import with_companions
from roslab.decide.system.compiled_with import compiled_with
from roslab.decide.system.names import Target, resolve
from roslab.decide.system.needs import ON_CUDA, compiler_of_cuda, needs, of_another_python
from roslab.decide.system.one_qt import of_another_qt
from roslab.decide.system.recipes import lies_elsewhere, linked
from roslab.decide.system.requested import requested
from roslab.decide.system.ubuntu_ros import ros_of_ubuntu
from roslab.decide.system.vendored import with_vendors, without_vendored
from roslab.decide.system.wheels import apt_for_wheels
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence
from roslab.knowledge.code_limits import satisfies
from roslab.knowledge.debugging import debugging
from roslab.knowledge.never import never
from roslab.knowledge.recipes import recipe
from roslab.knowledge.released import rosdep_keys
from roslab.values.dataclass import dataclass, field
from roslab.values.requirement import Requirement

_IN_ANY_ROS = ("catkin", "ros_base", "ros_core", "ament_cmake")


class Weight:
    """Weights of the reasons for a package; packages do not compete, so they only order the report."""

    KEY = 500  # of a package.xml
    DECLARED = 400  # must install
    GUESSED = 100


@dataclass(frozen=True, kw_only=True, slots=True)
class SystemPackages:
    """rosdep keys, declared and guessed packages, and libraries that no package contains."""

    rosdep: tuple[str, ...] = ()
    skip_keys: tuple[str, ...] = ()
    apt: tuple[str, ...] = ()
    apt_guessed: tuple[str, ...] = ()
    recipes: tuple[tuple[str, Dependency], ...] = ()
    """``(row of the table of recipes, what asks for it)``."""
    brought: tuple[str, ...] = ()
    """Packages that are needed too, and that others of these depend on."""

    @property
    def installed(self) -> tuple[str, ...]:
        """All packages of apt, those that are guessed, too."""
        return (*self.apt, *self.apt_guessed)


@dataclass
class _Found:
    """What was found so far, each name with the first place that asked for it."""

    declared: dict[str, Dependency | None] = field(default_factory=dict)
    guessed: dict[str, Dependency | Requirement] = field(default_factory=dict)
    recipes: dict[str, Dependency] = field(default_factory=dict)
    written: set[str] = field(default_factory=set)
    """Those that an author's install line names, whoever asked for them first."""
    skip: dict[str, None] = field(default_factory=dict)
    warnings: list[Warning_] = field(default_factory=list)
    unknown: dict[str, Warning_] = field(default_factory=dict)
    """Keys of which nothing says where they come from."""


def decide_system(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    target: Target,
    packages: Packages,
    python: Python,
    installed: tuple[Requirement, ...],
    base_packages: tuple[str, ...],
    sisters: frozenset[str],
    may_hold: Callable[[str], bool],
    tried: Mapping[str, str],
) -> Choice[SystemPackages]:
    """Return the system packages.

    ``installed`` is what pip installs, ``sisters`` are names that sources in the workspace provide;
    ``may_hold``: whether these may hold a package of a name; ``tried``: where the build looks for packages that nothing
    brings.
    """
    keys = declared_keys(packages, target, kind) if target.ros_distro else ()
    found = _Found(declared=dict.fromkeys((*config.apt, *base_packages)))
    found.skip = dict.fromkeys((*config.skip_keys, *(key.name for key in keys if key.name in sisters)))
    own = own_packages((key for key in keys if key.name not in found.skip), evidence, target)
    found.skip |= dict.fromkeys(own)
    unknown = [key for key in keys if not target.knows(key.name) and key.name not in rosdep_keys()]
    paged = by_page(without_vendored(unknown, target), evidence)
    found.skip |= dict.fromkeys((*own_targets(unknown, evidence), *sorted(paged)))
    submodules = tuple(source.name for source in evidence.sources if source.kind == "submodule")
    by_pip = {each.key for each in installed}
    ours = controllers((key for key in unknown if key.name not in tried and not may_hold(key.name)), evidence)
    for key in keys:
        if key.name not in found.skip:
            cloned, where = may_hold(key.name), tried.get(key.name, "")
            meant = of_controller(key, ours, target) or translate(
                key,
                target,
                cloned=cloned,
                submodules=submodules,
                tried=where,
                installed=by_pip,
                evidence=evidence,
            )
            _keep(key, meant, found)
    defined = ((each, False) for listed in own.values() for each in listed)
    needed = (*defined, *needs(evidence, packages, kind, target.ros_distro))
    in_apt = _left_to_apt(found, {d.name for d, _ in needed if d.namespace == "apt" and d.strength == "prose"})
    if instead := of_an_apt_source(tuple(found.unknown), target, evidence):
        found.warnings = [*(each for each in found.warnings if each not in found.unknown.values()), instead]
    by_hand = frozenset(address(git.url) for git in evidence.sources if git.installed)
    unsure = {key.name for key in keys if key in found.guessed.values()}  # CMake may require them, and says so
    known = frozenset({key.name for key in keys} - in_apt - unsure | packages.names | sisters | set(config.skip_keys))
    of_pip = imported_from_pip(evidence, installed)
    for dependency, trusted in needed:
        if dependency.name in known or of_another_python(dependency, target.ubuntu) or _for_debugging(dependency):
            continue
        if not only_imported(dependency, of_pip):
            _add(dependency, target, found, known, trusted=trusted, by_hand=by_hand)
    found.declared = compiled_with(needed, evidence, target) | found.declared
    for library, dependency in linked(needed, evidence, target.ubuntu):
        found.recipes.setdefault(library, dependency)
    of_extensions = ((each, True) for each in evidence.code if each.namespace == "link")
    found.warnings += lies_elsewhere((*needed, *of_extensions), evidence, target.ubuntu)
    for dependency in compiler_of_cuda(evidence, packages, kind, target.ubuntu) if not target.cuda else ():
        _add(dependency, target, found, known, trusted=True, by_hand=by_hand)
    of_ros = () if target.ros_distro else ros_of_ubuntu(evidence, python, target.ubuntu)
    for apt, asked in (*apt_for_wheels(python, installed, target.ubuntu, evidence), *of_ros):
        found.guessed.setdefault(apt, asked)
    found.guessed = with_vendors(found.guessed, target)
    refused = never(cuda=target.cuda)
    other = of_another_qt(found.guessed, found.declared, (each for each, _ in needed))
    kept = {n: d for n, d in found.guessed.items() if n not in {*found.declared, *other} and not refused.match(n)}
    _left_to_apt(found, {*found.declared, *kept})
    variant = config.base.ros.partition("-")[2] if config.base.ros else ""
    dropped = _drop(found, kept, target, [key.name for key in keys if key.name not in found.skip], variant)
    wanted = [name for name in requested(config, target.ubuntu) if name not in found.declared]
    said = (configured(config, "dependencies", name, f"apt.{index}") for index, name in enumerate(config.apt))
    chosen = Choice(
        answer=SystemPackages(
            rosdep=tuple(key.name for key in keys if key.name not in found.skip),
            skip_keys=tuple(found.skip),
            apt=tuple(found.declared),
            apt_guessed=tuple(sorted({*kept, *wanted})),
            recipes=tuple(found.recipes.items()),
            brought=dropped,
        ),
        reasons=(*said, *_explained(found.declared, kept, keys)),
        warnings=tuple(together(found.warnings)),
    )
    return with_companions(chosen, evidence, packages, target)


def _drop(
    found: _Found, kept: dict[str, Dependency | Requirement], target: Target, keys: list[str], variant: str
) -> tuple[str, ...]:
    """Take out what the base or other packages bring and no author named; return what others bring."""
    for name in [n for n in kept if n in held(target, variant) and n not in found.written]:
        del kept[name]
    sure = (*found.declared, *map(target.ros, keys))
    certain, likely = brought(sure, target), brought((*sure, *kept), target)
    dropped = [n for n, asked in found.declared.items() if n in certain and asked and n not in found.written]
    for name in dropped:
        del found.declared[name]
    near = brought((*sure, *kept), target, directly=True)  # a wheel's library is not left to what compiling needs
    bring = {n: near if isinstance(asked, Requirement) else likely for n, asked in kept.items()}
    guessed = [n for n in kept if n in bring[n] and n not in found.written]
    for name in guessed:
        del kept[name]
    return (*dropped, *guessed)


def _keep(key: Dependency, meant: Translated, found: _Found) -> None:
    for apt in meant.guessed:
        found.guessed.setdefault(apt, key)
    if meant.recipe:
        found.recipes.setdefault(meant.recipe, key)
    if meant.skip:
        found.skip[key.name] = None
    if meant.warning:
        found.warnings.append(meant.warning)
        found.unknown |= {key.name: meant.warning} if meant.unknown else {}


def _left_to_apt(found: _Found, names: set[str]) -> frozenset[str]:
    """Leave the unknown keys that apt installs under the same name to it; return them: ``libgmp-dev`` is no key."""
    for name in sorted(left := frozenset(names & found.unknown.keys())):
        found.skip[name] = None
        warning = found.unknown.pop(name)
        found.warnings = [each for each in found.warnings if each != warning]
    return left


def _add(
    dependency: Dependency,
    target: Target,
    found: _Found,
    known: frozenset[str],
    *,
    trusted: bool,
    by_hand: frozenset[str],
) -> None:
    """Add the packages of a name: declared if the build requires it and Ubuntu has it, else guessed.

    An optional library without a package is built if its address is among those that a page builds ``by_hand``.
    """
    if _useless(dependency, target):
        return
    meant = resolve(dependency, target)
    if dependency.namespace == "apt" and dependency.strength == "prose":
        found.written.update(meant.apt)
    required = dependency.namespace in {"cmake", "pkg-config"} or dependency.role == ON_CUDA
    sure = trusted and dependency.strength == "declared" and required
    if meant.recipe and trusted and (dependency.strength != "optional" or _written(meant.recipe, target, by_hand)):
        found.recipes.setdefault(meant.recipe, dependency)
    for apt in meant.apt:
        if apt.startswith("ros-") and _covered(apt, target, known):
            continue
        if sure and not apt.startswith("ros-"):
            found.declared.setdefault(apt, dependency)
        else:
            found.guessed.setdefault(apt, dependency)
    if dependency.strength != "optional":
        for apt in meant.beside:
            found.guessed.setdefault(apt, dependency)


def _useless(asked: Dependency, target: Target) -> bool:
    """Tell whether CMake only tries a library, in a release that the Ubuntu does not have: it goes on without."""
    tried = asked.namespace == "cmake" and asked.strength == "optional"
    if not (tried and asked.version and target.ubuntu):
        return False
    return not any(
        satisfies(asked.name, target.ubuntu, asked.version, ros=ros) for ros in {bool(target.ros_distro), False}
    )


def _for_debugging(dependency: Dependency) -> bool:
    """Tell whether a page or a script installs a debugger or its symbols, as people do on their own machines."""
    said = dependency.namespace == "apt" and dependency.strength == "prose"
    return said and bool(debugging().match(dependency.name))


def _written(library: str, target: Target, by_hand: frozenset[str]) -> bool:
    return any(built.name == library and address(built.repo) in by_hand for built in recipe(library, target.ubuntu))


def _covered(apt: str, target: Target, known: frozenset[str]) -> bool:
    """Tell whether a ROS package is there anyway: a key, the repository's own, from a source, or in every ROS image."""
    name = apt.split("-", 2)[-1].replace("-", "_")
    return name in known or apt in {target.ros(each) for each in _IN_ANY_ROS}


def _explained(
    declared: dict[str, Dependency | None], guessed: dict[str, Dependency | Requirement], keys: tuple[Dependency, ...]
) -> Iterator[Reason]:
    for key in keys:
        why = f"a {key.file.rpartition('/')[2]} asks for it ({key.role})"
        yield because("dependencies", key.name, why, key, weight=Weight.KEY)
    for name, dependency in (*declared.items(), *guessed.items()):
        if isinstance(dependency, Requirement):
            why = f"the wheel of {dependency.written} lacks it"
            place = dependency if dependency.file else None
            yield because("dependencies", name, why, place, weight=Weight.GUESSED)
        elif dependency is not None:
            why = how_asked(dependency).format(dependency.name) + (
                ", which is optional" if dependency.strength == "optional" else ""
            )
            weight = Weight.DECLARED if name in declared else Weight.GUESSED
            yield because("dependencies", name, why, dependency, weight=weight)
