"""What a repository is: ROS 1, ROS 2, deep learning on CUDA, plain Python or plain C++."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Reason
from roslab.decide.reasons import configured, ranked
from roslab.decide.workspace import packages_of, ros_versions
from roslab.evidence import places
from roslab.evidence.facts import Dependency, Evidence
from roslab.knowledge.distros import distro, distros

_FRAMEWORKS = ("torch", "tensorflow", "jax", "keras", "flax", "mxnet", "paddle", "cupy", "pycuda", "caffe", "chainer", "isaacgym", "tensorflow-gpu", "pytorch")
SMALL_WRAPPER = 3
"""A program in Python with at most so many ROS packages below its root has a ROS wrapper; it is no ROS repository."""


@dataclass(frozen=True, kw_only=True, slots=True)
class KindChoice:
    """The kind, with what speaks for and against."""

    kind: Kind
    reasons: tuple[Reason, ...]


def decide_kind(evidence: Evidence, config: Config) -> KindChoice:
    """Return what kind of repository it is."""
    reasons: list[Reason] = []
    if config.kind:
        reasons.append(configured(config, "kind", config.kind, "kind"))
    if config.base.ros and (known := distro(config.base.ros.partition("-")[0])):
        reasons.append(configured(config, "kind", f"ros{known.ros}", "base.ros"))
    elif config.base.cuda and not config.kind:
        reasons.append(configured(config, "kind", "cuda", "base.cuda"))
    reasons += _ros(evidence)
    reasons += _python(evidence)
    reasons += _cpp(evidence)
    if not reasons:
        reasons.append(Reason(question="kind", answer="python", reason="nothing says what it is", weight=1))
    best = max(reasons, key=lambda reason: reason.weight)
    answer: Kind = next(kind for kind in ("ros1", "ros2", "cuda", "python", "cpp") if kind == best.answer)  # type: ignore[assignment]
    return KindChoice(kind=answer, reasons=ranked(reasons, answer))


def _ros(evidence: Evidence) -> list[Reason]:
    packages = packages_of(evidence)
    macros = {project.file.rpartition("/")[0]: project.macros for project in evidence.cmake}
    reasons: list[Reason] = []
    by_version: dict[int, list[str]] = {1: [], 2: []}
    first: dict[int, tuple[str, int]] = {}
    for manifest in packages.built:
        for version in ros_versions(manifest, macros.get(manifest.file.rpartition("/")[0], ())):
            by_version[version].append(manifest.file)
            first.setdefault(version, (manifest.file, manifest.line))
    wrapper = _wrapper(evidence, [*by_version[1], *by_version[2]])
    for version, files in by_version.items():
        if files:
            both = bool(by_version[3 - version])
            weight = (200 if wrapper else 500) + (_leaning(evidence, version, len(files), len(by_version[3 - version])) if both else 0)
            what = "catkin" if version == 1 else "ament"
            aside = ", a wrapper beside a Python project" if wrapper else ""
            file, line = first[version]
            reasons.append(Reason(question="kind", answer=f"ros{version}", reason=f"{len(files)} package(s) built by {what}{aside}", file=file, line=line, weight=weight))
    if not packages.built:
        reasons += _meta(evidence)
    for project in evidence.cmake:
        if "rosbuild" in project.macros:
            reasons.append(Reason(question="kind", answer="ros1", reason="it is built by rosbuild", file=project.file, line=1, weight=90))
            break
    for manifest in packages.assets[:1]:
        reasons.append(
            Reason(question="kind", answer="ros1", reason="a package.xml with nothing to build beside it: a robot's description", file=manifest.file, line=1, weight=-10)
        )
    return reasons


def _wrapper(evidence: Evidence, manifests: list[str]) -> bool:
    """Tell whether the ROS packages are an addition to a Python program: few, below the root, its own code outside them."""
    folders = {file.rpartition("/")[0] for file in manifests}
    if not manifests or "" in folders or len(folders) > SMALL_WRAPPER:
        return False
    compiled = any(project.executables and _within(project.file, folders) for project in evidence.cmake)
    depth = 0 if compiled else 2  # packages of C++ nodes outweigh a script's requirements somewhere in the tree
    own = [p.file for p in evidence.python if p.installable] + [c.file for c in evidence.conda]
    own += [r.file for r in evidence.requirements if r.purpose == "run"]
    if not any(file.count("/") <= depth and not _within(file, folders) and not places.vendored(file) for file in own):
        return False
    code = {d.file for d in evidence.code if d.namespace == "import"} | {script.file for script in evidence.scripts}
    inside = sum(_within(file, folders) for file in code)
    return 2 * inside < len(code)


def _within(file: str, folders: set[str]) -> bool:
    return any(file.startswith(folder + "/") for folder in folders)


def _leaning(evidence: Evidence, version: int, count: int, other: int) -> int:
    """Break the tie of a repository made for both: the branch, then the author's images, CI and README, then the packages."""
    ranks = {"branch": 60, "recipe": 12, "ci": 10, "readme": 6, "filename": 4}
    names = {name: found.ros for name, found in distros().items()}
    names["ros1"], names["ros2"] = 1, 2
    score = 0
    for source, rank in ranks.items():
        sides = {names[m.value] for m in evidence.mentions if m.topic == "distro" and m.source == source and m.value in names}
        if sides == {version}:
            score += rank
    return score + (5 if count > other else 0) + (2 if version == 2 else 0)


def _meta(evidence: Evidence) -> list[Reason]:
    """Read a repository that only lists others: its vcs files and what its pages say."""
    listed = [source for source in evidence.sources if source.kind == "vcs"]
    if not listed:
        return []
    sides = [found.ros for m in evidence.mentions if m.topic == "distro" and (found := distro(m.value))]
    version = 2 if sides.count(2) >= sides.count(1) and listed[0].file.endswith(".repos") or sides.count(2) > sides.count(1) else 1
    if not sides:
        return []
    reason = f"{len(listed)} repositories to import and a ROS {version} distribution to do it for"
    return [Reason(question="kind", answer=f"ros{version}", reason=reason, file=listed[0].file, line=listed[0].line, weight=300)]


def _python(evidence: Evidence) -> list[Reason]:
    place = _python_place(evidence)
    framework = _framework(evidence)
    reasons = []
    if place:
        file, line, reason, weight = place
        answer = "cuda" if framework else "python"
        reasons.append(Reason(question="kind", answer=answer, reason=reason, file=file, line=line, weight=weight))
    if framework:
        file, line, reason = framework
        reasons.append(Reason(question="kind", answer="cuda", reason=reason, file=file, line=line, weight=(place[3] + 5) if place else 130))
    return reasons


def _python_place(evidence: Evidence) -> tuple[str, int, str, int] | None:
    for project in evidence.python:
        if project.installable and not places.vendored(project.file):
            return project.file, project.line, "pip can install it", 400 if not project.folder else 250
    for environment in evidence.conda:
        if not places.vendored(environment.file):
            return environment.file, environment.line, "a conda environment", 380 if "/" not in environment.file else 240
    for requirement in evidence.requirements:
        if requirement.purpose == "run":
            return requirement.file, requirement.line, "Python requirements", 350 if "/" not in requirement.file else 230
    if evidence.scripts:
        script = evidence.scripts[0]
        return script.file, script.line, "a Python program", 120
    imports = [d for d in evidence.code if d.namespace == "import"]
    return (imports[0].file, imports[0].line, "Python code", 100) if imports else None


def _framework(evidence: Evidence) -> tuple[str, int, str] | None:
    for dependency in _pip(evidence):
        name = dependency.name.lower().replace("_", "-")
        stem = name.partition("[")[0].partition("=")[0].partition(">")[0].partition("<")[0].partition("~")[0].partition(";")[0].strip()
        if stem in _FRAMEWORKS:
            return dependency.file, dependency.line, f"it needs {stem}"
    for environment in evidence.conda:
        for package in environment.packages:
            name = package.partition("=")[0].partition(">")[0].partition("<")[0].strip()
            if name in _FRAMEWORKS or name in {"cudatoolkit", "pytorch-cuda"}:
                return environment.file, environment.line, f"its environment has {name}"
    if evidence.cuda_files:
        return evidence.cuda_files[0], 1, "CUDA sources"
    for project in evidence.cmake:
        if "cuda" in project.macros and not places.vendored(project.file) and not places.example(project.file):
            return project.file, 1, "its CMake needs CUDA"
    return None


def _pip(evidence: Evidence) -> list[Dependency]:
    found = [d for p in evidence.python if not places.vendored(p.file) for d in p.dependencies]
    found += [d for r in evidence.requirements if r.purpose != "vendored" for d in r.dependencies]
    found += [d for c in evidence.conda for d in c.dependencies]
    found += [d for d in evidence.prose if d.namespace == "pip"]
    found += [d for r in evidence.recipes if r.purpose == "project" for d in r.dependencies if d.namespace == "pip"]
    return found + [d for d in evidence.code if d.namespace == "import" and d.strength == "used"]


def _cpp(evidence: Evidence) -> list[Reason]:
    tops = [p for p in evidence.cmake if p.top_level and not places.vendored(p.file)]
    tops.sort(key=lambda p: (p.file.count("/"), p.file))
    if not tops:
        return []
    top = tops[0]
    root = "/" not in top.file
    answer = "cuda" if "cuda" in top.macros and "CUDA" in top.languages else "cpp"
    bindings = next((p for p in evidence.python if not p.folder and "cmake" in p.extensions), None)
    if root and bindings and _mostly_cpp(evidence):
        return [Reason(question="kind", answer=answer, reason="a CMake project; Python only binds it", file=top.file, line=1, weight=450)]
    return [Reason(question="kind", answer=answer, reason="a CMake project", file=top.file, line=1, weight=360 if root else 150)]


def _mostly_cpp(evidence: Evidence) -> bool:
    """Compare the places of includes with those of imports, each a file of its own."""
    included = {d.file for d in evidence.code if d.namespace == "include"}
    imported = {d.file for d in evidence.code if d.namespace == "import"}
    return len(included) > len(imported)
