"""What a repository is: ROS 1, ROS 2, deep learning on CUDA, plain Python or plain C++."""

from __future__ import annotations

from dataclasses import dataclass
from typing import cast

from roslab.config.model import Config, Kind
from roslab.decide.cuda.signs import framework
from roslab.decide.decision import Reason, Warning_
from roslab.decide.reasons import Placed, because, configured, ranked
from roslab.decide.ros.workspace import packages_of, ros_versions
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.knowledge.distros import distro, distros

SMALL_WRAPPER = 3
"""A program in Python with at most so many ROS packages below its root has a ROS wrapper; it is no ROS repository."""
_LEANING = {"branch": 60, "dockerfile": 12, "ci": 10, "readme": 6, "filename": 4}


@dataclass(frozen=True, kw_only=True, slots=True)
class KindChoice:
    """The kind, with what speaks for and against."""

    kind: Kind
    reasons: tuple[Reason, ...]
    warnings: tuple[Warning_, ...] = ()


def decide_kind(evidence: Evidence, config: Config) -> KindChoice:
    """Return what kind of repository it is."""
    reasons: list[Reason] = []
    if config.kind:
        reasons.append(configured(config, "kind", config.kind, "kind"))
    elif config.base.ros and (known := distro(config.base.ros.partition("-")[0])):
        reasons.append(configured(config, "kind", f"ros{known.ros}", "base.ros"))
    elif config.base.cuda:
        reasons.append(configured(config, "kind", "cuda", "base.cuda"))
    reasons += [*_ros(evidence), *_python(evidence), *_cpp(evidence)]
    if not reasons:
        reasons.append(because("kind", "python", "nothing says what it is", weight=1))
    best = max(reasons, key=lambda reason: reason.weight)
    kind = cast("Kind", best.answer)
    return KindChoice(kind=kind, reasons=ranked(reasons, kind), warnings=_warnings(evidence, kind))


def _ros(evidence: Evidence) -> list[Reason]:
    packages = packages_of(evidence)
    macros = {project.file.rpartition("/")[0]: project.macros for project in evidence.cmake}
    by_version: dict[int, list[PackageManifest]] = {1: [], 2: []}
    for manifest in packages.built:
        for version in ros_versions(manifest, macros.get(manifest.file.rpartition("/")[0], ())):
            by_version[version].append(manifest)
    wrapper = _wrapper(evidence, [m.file for m in (*by_version[1], *by_version[2])])
    reasons: list[Reason] = []
    for version, made in by_version.items():
        if not made:
            continue
        others = len(by_version[3 - version])
        weight = (200 if wrapper else 500) + (_leaning(evidence, version, len(made) - others) if others else 0)
        number = "a package" if len(made) == 1 else f"{len(made)} packages"
        why = f"{number} built by {'catkin' if version == 1 else 'ament'}"
        why += ", a wrapper beside a Python project" if wrapper else ""
        reasons.append(because("kind", f"ros{version}", why, made[0], weight=weight))
    if not packages.built:
        reasons += _meta(evidence)
    rosbuild = [project for project in evidence.cmake if "rosbuild" in project.macros]
    if rosbuild:
        weight = 365 if _all_rosbuild(evidence) else 90
        reasons.append(because("kind", "ros1", "it is built by rosbuild", rosbuild[0], weight=weight))
    for manifest in packages.assets[:1]:
        why = "a package.xml with nothing to build beside it: a robot's description"
        reasons.append(because("kind", "ros1", why, manifest, weight=-10))
    return reasons


def _all_rosbuild(evidence: Evidence) -> bool:
    """Tell whether everything that CMake starts with is rosbuild's; one such folder in a program is an example."""
    tops = [project for project in evidence.cmake if not places.vendored(project.file)]
    nearest = min((project.file.count("/") for project in tops), default=0)
    return all("rosbuild" in project.macros for project in tops if project.file.count("/") == nearest)


def _warnings(evidence: Evidence, kind: Kind) -> tuple[Warning_, ...]:
    """Say what of the repository is not built although its kind is clear."""
    old = next((project for project in evidence.cmake if "rosbuild" in project.macros), None)
    if kind != "ros1" or old is None or packages_of(evidence).built:
        return ()
    message = "rosbuild's packages (manifest.xml) are not built: catkin and colcon do not know them"
    hint = "the image has what they need; build them under `custom` in roslab.yaml, by rosmake"
    return (Warning_(message=f"{message}; {hint}", file=old.file, line=old.line),)


def _wrapper(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether the ROS packages are an addition to a Python program: few, deep, its own code outside them."""
    folders = {file.rpartition("/")[0] for file in manifests}
    if not manifests or "" in folders or len(folders) > SMALL_WRAPPER:
        return False
    compiled = any(project.executables and _within(project.file, folders) for project in evidence.cmake)
    depth = 0 if compiled else 2  # packages of C++ nodes outweigh a script's requirements somewhere in the tree
    own = [p.file for p in evidence.python if p.installable] + [c.file for c in evidence.conda]
    own += [r.file for r in evidence.requirements if r.purpose == "run"]
    if not any(f.count("/") <= depth and not _within(f, folders) and not places.vendored(f) for f in own):
        return False
    code = {d.file for d in evidence.code if d.namespace == "import"} | {script.file for script in evidence.programs}
    inside = sum(_within(file, folders) for file in code)
    return 2 * inside < len(code)


def _within(file: str, folders: set[str]) -> bool:
    return any(file.startswith(folder + "/") for folder in folders)


def _leaning(evidence: Evidence, version: int, majority: int) -> int:
    """Break the tie of a repository made for both: the branch, then images, CI and README, then the packages."""
    sides_of = {name: found.ros for name, found in distros().items()} | {"ros1": 1, "ros2": 2}
    score = 5 * (majority > 0) + 2 * (version == 2)
    for source, rank in _LEANING.items():
        named = (m.value for m in evidence.mentions if m.topic == "distro" and m.source == source)
        if {sides_of[value] for value in named if value in sides_of} == {version}:
            score += rank
    return score


def _meta(evidence: Evidence) -> list[Reason]:
    """Read a repository that only lists others: its vcs files, its submodules and the distributions that pages name.

    A list at the root that only ROS's tools read outweighs requirements; submodules count with one of ROS's builders.
    """
    listed = [source for source in evidence.sources if source.kind == "vcs"]
    sides = [found.ros for m in evidence.mentions if m.topic == "distro" and (found := distro(m.value))]
    own = [source for source in listed if "/" not in source.file and source.file.endswith((".repos", ".rosinstall"))]
    tools = {m.value for m in evidence.mentions if m.topic == "build_tool"}
    builders = tools & {"catkin_make", "catkin_tools", "colcon"}
    if not listed and builders and sides:
        listed = [source for source in evidence.sources if source.kind == "submodule"]
    if not listed or not (sides or own):
        return []
    lead = sides.count(2) - sides.count(1)
    version = 2 if lead > 0 or (lead == 0 and listed[0].file.endswith(".repos")) else 1
    why = f"{len(listed)} repositories to import" + (f" and a ROS {version} distribution to do it for" if sides else "")
    return [because("kind", f"ros{version}", why, (own or listed)[0], weight=370 if own else 300)]


def _python(evidence: Evidence) -> list[Reason]:
    place = _python_place(evidence)
    found = framework(evidence)
    reasons = []
    if place:
        at, why, weight = place
        reasons.append(because("kind", "cuda" if found else "python", why, at, weight=weight))
    if found:
        reasons.append(because("kind", "cuda", found.why, found, weight=place[2] + 5 if place else 130))
    return reasons


def _python_place(evidence: Evidence) -> tuple[Placed, str, int] | None:
    for project in evidence.python:
        if project.installable and not places.vendored(project.file):
            return project, "pip can install it", 250 if project.folder else 400
    for environment in evidence.conda:
        if not places.vendored(environment.file):
            return environment, "a conda environment", 240 if "/" in environment.file else 380
    for requirement in evidence.requirements:
        if requirement.purpose == "run":
            return requirement, "Python requirements", 230 if "/" in requirement.file else 350
    if evidence.programs:
        return evidence.programs[0], "a Python program", 120
    imported = next((d for d in evidence.code if d.namespace == "import"), None)
    return (imported, "Python code", 100) if imported else None


def _cpp(evidence: Evidence) -> list[Reason]:
    tops = [p for p in evidence.cmake if p.top_level and not places.vendored(p.file)]
    if not tops:
        return []
    top = min(tops, key=lambda p: (p.file.count("/"), p.file))
    root = "/" not in top.file
    compiled = "CUDA" in top.languages or evidence.cuda_files
    answer = "cuda" if "cuda" in top.macros and compiled else "cpp"
    bindings = any(not project.folder and "cmake" in project.extensions for project in evidence.python)
    if root and bindings and _mostly_cpp(evidence):
        return [because("kind", answer, "a CMake project; Python only binds it", top, weight=450)]
    weight = 360 if root else 150 if _mostly_cpp(evidence) else 90
    return [because("kind", answer, "a CMake project", top, weight=weight)]


def _mostly_cpp(evidence: Evidence) -> bool:
    """Compare the files that include something with those that import something."""
    included = {d.file for d in evidence.code if d.namespace == "include"}
    imported = {d.file for d in evidence.code if d.namespace == "import"}
    return len(included) > len(imported)
