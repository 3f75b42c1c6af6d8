"""System packages: what is declared and must install, what is guessed and is installed where apt knows it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Python, Reason, Warning_
from roslab.decide.names import Target, resolve
from roslab.decide.wheels import apt_for_wheels
from roslab.decide.workspace import Packages
from roslab.evidence import places
from roslab.evidence.conditions import holds
from roslab.evidence.facts import Dependency, Evidence
from roslab.knowledge.libraries import library
from roslab.knowledge.never import never
from roslab.knowledge.released import released, rosdep_keys

_STARTED = re.compile(r"\b(?:rosrun|roslaunch|ros2\s+(?:run|launch))\s+(?:--?\S+\s+)*([a-z][a-z0-9_]+)\s")
_NOT_INSTALLED = frozenset({"doc"})
"""rosdep leaves documentation alone."""


@dataclass(frozen=True, kw_only=True, slots=True)
class SystemChoice:
    """Keys, packages in two levels of trust, and the libraries that no package holds."""

    rosdep: tuple[str, ...] = ()
    skip_keys: tuple[str, ...] = ()
    apt: tuple[str, ...] = ()
    apt_guessed: tuple[str, ...] = ()
    recipes: tuple[tuple[str, Dependency], ...] = ()
    """``(row of the table of recipes, what asks for it)``."""
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def declared_keys(packages: Packages, target: Target, kind: Kind) -> tuple[Dependency, ...]:
    """Return the keys of the packages that are built, each once, their conditions evaluated."""
    variables = {
        "ROS_VERSION": "1" if kind == "ros1" else "2",
        "ROS_DISTRO": target.ros_distro or "",
        "ROS_PYTHON_VERSION": "2" if target.ubuntu in {"trusty", "xenial", "bionic"} and kind == "ros1" else "3",
    }
    found: dict[str, Dependency] = {}
    for manifest in packages.built:
        for dependency in manifest.dependencies:
            if dependency.role in _NOT_INSTALLED or dependency.name in packages.names:
                continue
            if holds(dependency.condition, variables):
                found.setdefault(dependency.name, dependency)
    return tuple(found[name] for name in sorted(found))


def code_needs(evidence: Evidence, packages: Packages) -> tuple[Dependency, ...]:
    """Return what CMake files look for, outside the packages that are not built."""
    skipped = {m.file.rpartition("/")[0] for m in packages.left_out if m.ignored}
    return tuple(
        dependency
        for project in evidence.cmake
        if not places.vendored(project.file) and not any(_inside(project.file, folder) for folder in skipped)
        for dependency in project.dependencies
        if dependency.role != "test" and dependency.name not in packages.names
    )


def _inside(path: str, folder: str) -> bool:
    return not folder or path.startswith(folder + "/")


def decide_system(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    target: Target,
    packages: Packages,
    python: Python,
    base_packages: tuple[str, ...],
    sisters: frozenset[str],
) -> SystemChoice:
    """Return the system packages; ``sisters`` are the names that sources in the workspace answer for."""
    keys = declared_keys(packages, target, kind) if target.ros_distro else ()
    reasons: list[Reason] = []
    warnings: list[Warning_] = []
    declared: dict[str, Dependency | None] = {}
    guessed: dict[str, Dependency] = {}
    recipes: dict[str, Dependency] = {}
    skip = dict.fromkeys((*config.skip_keys, *(key.name for key in keys if key.name in sisters)))
    for index, name in enumerate(config.apt):
        declared[name] = None
        place = config.place(f"apt.{index}")
        reasons.append(Reason(question="dependencies", answer=name, reason="apt says so", file=place.file if place else config.file, line=place.line if place else None, weight=1000))
    for name in base_packages:
        declared[name] = None
    for key in keys:
        _key(key, target, sisters, skip, declared, recipes, warnings)
    known_keys = {key.name for key in keys}
    for dependency, trusted in _needs(evidence, packages, kind):
        name = dependency.name
        if name in known_keys or name in packages.names or name in sisters or name in config.skip_keys:
            continue
        found = resolve(dependency, target)
        if found.recipe and dependency.strength != "optional" and trusted:
            recipes.setdefault(found.recipe, dependency)
        for apt in found.apt:
            if _covered(apt, target, known_keys, packages, sisters):
                continue
            if trusted and dependency.strength == "declared" and dependency.namespace in {"cmake", "pkg-config"} and not apt.startswith("ros-"):
                declared.setdefault(apt, dependency)
            else:
                guessed.setdefault(apt, dependency)
        if dependency.strength != "optional":
            for apt in found.beside:
                guessed.setdefault(apt, dependency)
    for apt, dependency in apt_for_wheels(python, target.ubuntu, evidence):
        guessed.setdefault(apt, dependency)
    refused = never()
    kept = {name: dependency for name, dependency in guessed.items() if name not in declared and not refused.match(name)}
    reasons += _explained(declared, kept, keys)
    return SystemChoice(
        rosdep=tuple(key.name for key in keys if key.name not in sisters and key.name not in skip),
        skip_keys=tuple(skip),
        apt=tuple(declared),
        apt_guessed=tuple(sorted(kept)),
        recipes=tuple(recipes.items()),
        reasons=tuple(reasons),
        warnings=tuple(warnings),
    )


def _covered(apt: str, target: Target, keys: set[str], packages: Packages, sisters: frozenset[str]) -> bool:
    """Tell whether a ROS package is already a key, the repository's own or a sister's."""
    if not apt.startswith("ros-"):
        return False
    name = apt.split("-", 2)[2].replace("-", "_")
    return name in keys or name in packages.names or name in sisters or apt in {target.ros(n) for n in ("catkin", "ros_base", "ros_core", "ament_cmake")}


def _key(
    key: Dependency,
    target: Target,
    sisters: frozenset[str],
    skip: dict[str, None],
    declared: dict[str, Dependency | None],
    recipes: dict[str, Dependency],
    warnings: list[Warning_],
) -> None:
    """A key that rosdep cannot know: a name of CMake's is translated, any other is named with its place."""
    name = key.name
    if name in sisters or name in skip or name in rosdep_keys() or name in released(target.ros_distro or ""):
        return
    found = library("cmake", name, target.ubuntu)
    if found and (found.apt or found.recipe):
        skip[name] = None
        for apt in found.apt:
            declared.setdefault(apt, key)
        if found.recipe and not found.apt:
            recipes.setdefault(found.recipe, key)
        message = f"{name} is no key of rosdep but a name of CMake's: {' '.join(found.apt) or found.recipe + ' from source'} is installed for it"
    else:
        message = f"rosdep knows no {name} for ROS {target.ros_distro}, and nothing here says where it comes from: name it under source in roslab.yaml"
    warnings.append(Warning_(message=message, file=key.file, line=key.line))


def _needs(evidence: Evidence, packages: Packages, kind: Kind) -> Iterator[tuple[Dependency, bool]]:
    """Yield what is needed, and whether its place is trusted: what the build really runs through."""
    compiled = kind in {"ros1", "ros2", "cpp"}
    folders = [manifest.file.rpartition("/")[0] for manifest in packages.built]
    for dependency in code_needs(evidence, packages):
        inside = not folders or any(_inside(dependency.file, folder) for folder in folders)
        aside = places.example(dependency.file) or places.test(dependency.file) or places.documentation(dependency.file)
        if compiled or not aside:
            yield dependency, compiled and inside and not aside
    ros = kind in {"ros1", "ros2"}
    for dependency in evidence.code:
        if dependency.namespace == "include" or (ros and dependency.namespace == "ros"):
            yield dependency, False
    if ros:
        for launch in evidence.launch:
            for dependency in launch.dependencies:
                yield dependency, False
        for dependency in evidence.code:
            if dependency.namespace == "import":
                yield _as_ros(dependency), False
        for dependency in started(evidence):
            yield dependency, False
    for dependency in _prose(evidence):
        yield dependency, False


def _as_ros(dependency: Dependency) -> Dependency:
    return Dependency(namespace="ros", name=dependency.name, strength=dependency.strength, file=dependency.file, line=dependency.line, role="exec")


def started(evidence: Evidence) -> Iterator[Dependency]:
    """Yield the ROS packages of the commands that pages tell people to run: ``rosrun rviz rviz``, ``ros2 launch PKG …``."""
    for mention in evidence.mentions:
        if mention.topic == "command" and (match := _STARTED.search(mention.text)):
            yield Dependency(namespace="ros", name=match[1], strength="prose", file=mention.file, line=mention.line, role="exec")


def _prose(evidence: Evidence) -> Iterable[Dependency]:
    """Yield what pages, CI and the author's own images install by apt."""
    for dependency in evidence.prose:
        if dependency.namespace == "apt":
            yield dependency
    for recipe in evidence.recipes:
        if recipe.purpose in {"project", "ci"}:
            for dependency in recipe.dependencies:
                if dependency.namespace == "apt":
                    yield dependency


def _explained(declared: dict[str, Dependency | None], guessed: dict[str, Dependency], keys: tuple[Dependency, ...]) -> Iterator[Reason]:
    for key in keys:
        yield Reason(question="dependencies", answer=key.name, reason=f"a key of a package.xml ({key.role})", file=key.file, line=key.line, weight=500)
    for name, dependency in (*declared.items(), *guessed.items()):
        if dependency is not None:
            what = {"cmake": "find_package", "pkg-config": "pkg-config", "link": "linked", "include": "included", "ros": "a ROS package in use", "apt": "an install line"}
            how = what.get(dependency.namespace, dependency.namespace)
            yield Reason(
                question="dependencies",
                answer=name,
                reason=f"{how}: {dependency.name} ({dependency.strength})",
                file=dependency.file,
                line=dependency.line,
                weight=400 if name in declared else 100,
            )
