"""Which manifests of the tree pip or conda installs from: requirement files, a conda environment, projects."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from roslab.config.model import Config, Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.beside_lock import beside_lock, left_to_lock
from roslab.decide.python.compiling import COMPILED_ON_IMPORT
from roslab.decide.python.gpu_projects import only_on_gpu
from roslab.decide.python.imported_submodules import imported
from roslab.decide.python.machine_lists import not_installed, of_machines
from roslab.decide.python.package_folders import around_packages, below
from roslab.decide.python.parts import of_baselines, of_parts
from roslab.decide.python.pins import DEVELOPMENT
from roslab.decide.ros.workspace import nothing_builds, types
from roslab.evidence import places
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence, Mention, RequirementFile
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.not_on_index import not_on_index
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

VARIANT = pattern(
    r"(?:^|[-_.])(?:frozen|freeze|lock|locked|full|all|extra|extras|optional|mac|macos|osx|darwin|windows|win|"
    r"cpu|gpu|cuda|rocm|tpu|jetson|arm|colab|"
    r"notebooks?|examples?|demo|eval|train|py2|python2|py27|min|minimum|old|backup|hpc|cluster|benchmark|ros|"
    r"real|robot|server|web|app|viz|vis)(?:[-_.\d]|$)",
    re.IGNORECASE,
)
"""A file for one use of several, or of one machine."""
MAX_PROJECTS = 6
"""Of those that nothing names."""
MAX_NAMED = 30


def for_reference(evidence: Evidence) -> frozenset[str]:
    """Return the lists that a page names as a reference only, while it installs packages by lines of its own."""
    asked = [each for each in evidence.prose_pip if each.role in {"environment", "file"}]
    named = {m.value for m in evidence.mentions if m.topic == "reference" and _installs(evidence, m.file)}
    return frozenset(named - {resolve(each, named) for each in asked})


def _installs(evidence: Evidence, page: str) -> bool:
    return any(each.file == page and each.name and not each.role for each in evidence.prose_pip)


def of_pages_below(evidence: Evidence) -> frozenset[str]:
    """Return the lists at the root that only pages of folders ask for, where a page at the root installs the project.

    The project says itself what it needs; each of the pages is about a part. One of the documentation is about all.
    """
    usable = {project.folder for project in evidence.python if project.installable}
    lists = {file.file for file in evidence.requirements if "/" not in file.file}
    if not declares(evidence):
        return frozenset()
    pages = [asked for asked in evidence.prose_pip if asked.file.endswith((".md", ".rst"))]
    below = {asked for asked in pages if "/" in asked.file and not places.documentation(asked.file)}
    others = [asked for asked in evidence.prose_pip if asked not in below]
    others += [asked for authored in evidence.dockerfiles for asked in authored.requirements]
    parts = {folder for folder in usable if folder}
    whole = (asked for asked in pages if "/" not in asked.file and asked.role == "project")
    if all(resolve(asked, parts) for asked in whole):
        return frozenset()
    asked_below, asked_above = (
        {resolve(asked, lists) for asked in found if asked.role in {"file", "environment"}} for found in (below, others)
    )
    return frozenset(path for path in asked_below - asked_above if path)


def declares(evidence: Evidence) -> bool:
    """Tell whether pip can install the project at the root, which then says what it needs.

    A list in a folder is then a part's, unless a page has it installed.
    """
    own = (project for project in evidence.python if project.installable and not project.folder)
    return any(asked.role not in {"extra", "test"} for project in own for asked in project.requirements)


def left_to_parts(evidence: Evidence, kind: Kind, chosen: Collection[RequirementFile]) -> Iterator[Warning_]:
    """Yield a warning for each of these lists, and of those beside a lock, that is not among the chosen files."""
    why = "only pages of folders ask for it, and the page at the root has pip install the project alone"
    yield from not_installed(evidence, of_pages_below(evidence), chosen, why)
    why = "it is of what the code is compared with, and no page at the root runs or installs that"
    yield from not_installed(evidence, of_baselines(evidence, kind), chosen, why)
    yield from left_to_lock(evidence, chosen)


def requirement_files(evidence: Evidence, config: Config, kind: Kind, conda: str | None) -> tuple[RequirementFile, ...]:
    """Return the files to install: roslab.yaml's, else what the README installs and the root's, else the nearest.

    None is nearest where the project at the root says what it needs.
    """
    if config.requirements is not None:
        wanted = {posixpath.normpath(path) for path in config.requirements}
        return tuple(file for file in evidence.requirements if file.file in wanted)
    if conda:  # one of tests, too: conda hands it to pip
        return tuple(file for each in evidence.conda if each.file == conda for file in files_of(evidence, each))
    aside = for_reference(evidence) | of_parts(evidence) | of_machines(evidence) | of_pages_below(evidence)
    aside |= beside_lock(evidence) | of_baselines(evidence, kind)
    run = {
        file.file: file
        for file in evidence.requirements
        if file.purpose == "run" and not places.example(file.file) and file.file not in aside
    }
    chosen: dict[str, RequirementFile] = {}
    for asked in _prose(evidence):
        if asked.role in {"file", "environment"} and (path := resolve(asked, run)):
            chosen[path] = run[path]
    root = [file for path, file in run.items() if "/" not in path or re.match(r"^requirements?/[^/]+$", path)]
    plain = [file for file in root if not VARIANT.search(file.file.rpartition(".")[0])]
    standard = [file for file in plain if re.search(r"(?:^|/)requirements?\.(?:txt|in)$", file.file)]
    for file in standard or plain[:3] or ([] if chosen else root[:1]):
        chosen.setdefault(file.file, file)
    if kind in {"ros1", "ros2"} or not (chosen or declares(evidence)):
        around = around_packages(evidence) if kind in {"ros1", "ros2"} else frozenset()
        named = {path: below(path, around).rpartition(".")[0] for path in run}
        nested = [file for path, file in run.items() if path.count("/") <= 3 and not VARIANT.search(named[path])]
        depth = min((file.file.count("/") for file in nested), default=0)
        for file in nested if kind in {"ros1", "ros2"} else [f for f in nested if f.file.count("/") == depth][:4]:
            chosen.setdefault(file.file, file)
    included = {path for file in chosen.values() for path in file.includes}
    return tuple(
        chosen[path] for path in sorted(chosen, key=lambda path: (path.count("/"), path)) if path not in included
    )


def _prose(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what READMEs at the root, scripts and the project's own Dockerfiles install with pip."""
    for asked in evidence.prose_pip:
        if asked.file.count("/") <= 1 and not DEVELOPMENT.search(asked.file):
            yield asked
    for authored in evidence.dockerfiles:
        if authored.purpose in {"project", "deploy"}:
            yield from authored.requirements


def resolve(asked: Requirement, known: Iterable[str]) -> str | None:
    """Return the path in the tree that an argument means: from the root, from its own folder, or by a unique suffix."""
    name = asked.written.partition("[")[0].strip("\"'")
    folder = asked.file.rpartition("/")[0]
    for candidate in (posixpath.normpath(name), posixpath.normpath(posixpath.join(folder, name))):
        if candidate in known:
            return candidate
    parts = [part for part in name.split("/") if part not in {"", ".", "..", "~"}]  # "pip install ." in a folder
    for start in range(len(parts)):
        tail = "/".join(parts[start:])
        if tail in known:
            return tail
    tail = "/" + "/".join(parts[-2:])
    ends = [path for path in known if path.endswith(tail)] if parts else []
    return ends[0] if len(ends) == 1 else None


def projects(
    evidence: Evidence,
    kind: Kind,
    conda: str | None,
    files: Iterable[RequirementFile] = (),
    compiled: Collection[str] = frozenset(),
) -> tuple[PythonProject, ...]:
    """Return the folders to install: the root, what a README or the given files install, else the nearest.

    A README that installs its own folder says nothing of the folders beside it. Beside a program of C++ that is the
    only project below the root, where the root is none. Those that are ``compiled`` otherwise are left out.
    """
    ros = kind in {"ros1", "ros2"}
    by_cmake = {project.file.rpartition("/")[0] for project in evidence.cmake}
    there = (m for m in evidence.manifests if ros and not m.ignored and not nothing_builds(m, by_cmake))
    manifests = {manifest.file.rpartition("/")[0] for manifest in there}
    by_cmake_alone = {
        manifest.file.rpartition("/")[0] for manifest in evidence.manifests if types(manifest) == {"cmake"}
    }
    installable = (p for p in evidence.python if p.installable and not only_on_gpu(p, kind))
    usable = {p.folder: p for p in installable if p.folder not in compiled}
    chosen: dict[str, PythonProject] = {}
    if "" in usable and "" not in manifests:
        members = {asked.key for asked in usable[""].requirements if asked.role == "member"}
        chosen = {p.folder: p for p in usable.values() if p.name and canonicalize_name(p.name) in members}
        chosen[""] = usable[""]
    listed = [asked for each in evidence.conda if each.file == conda for asked in each.requirements]
    listed += [asked for file in with_includes(evidence, files) for asked in file.requirements]
    alone = not chosen
    for asked in (*_prose(evidence), *listed):
        if asked.role != "project" or asked.written in {".", "./"}:
            continue
        folder = resolve(asked, {folder for folder in usable if folder})
        if folder and folder not in manifests - by_cmake_alone:  # plain CMake leaves the Python part to pip
            chosen.setdefault(folder, usable[folder])
            alone = alone and asked.file.rpartition("/")[0] == folder
    here = kind == "cpp" and "" not in usable and _installs_here(evidence)
    if alone and (here or kind != "cpp"):
        own = [
            folder
            for folder in usable
            if not _inside(folder, manifests if _compiles(usable[folder]) else manifests - by_cmake_alone)
            and not places.vendored(folder + "/")
            and not places.test(folder + "/")
            and not places.example(folder + "/")
            and not places.documentation(folder + "/")
        ]
        depth = min((folder.count("/") for folder in own), default=0)
        near = [folder for folder in own if folder.count("/") == depth and depth <= 1]
        near = near if not here or len(near) == 1 else []
        chosen |= {folder: usable[folder] for folder in near[:MAX_PROJECTS]}
    chosen |= {folder: usable[folder] for folder in imported(usable.values())}
    chosen |= {} if ros else {project.folder: project for project in usable.values() if _unpacked(project)}
    siblings = [m for m in evidence.mentions if m.topic == "sibling" and m.value in usable.keys() - manifests]
    return tuple(_with_needed(list(chosen.values()), usable, manifests, siblings)[:MAX_NAMED])


def _installs_here(evidence: Evidence) -> bool:
    """Tell whether a page at the root has pip install the folder that the reader is in."""
    asked = (each for each in _prose(evidence) if each.role == "project" and "/" not in each.file)
    return any(each.written in {".", "./"} for each in asked)


def _unpacked(project: PythonProject) -> bool:
    """Tell whether a project is of an archive behind a login: who has unpacked it in the tree needs it."""
    row = not_on_index().get(canonicalize_name(project.name or ""))
    return row is not None and bool(row.unpacked) and f"/{project.folder}".endswith(f"/{row.unpacked}")


def _with_needed(
    chosen: Sequence[PythonProject],
    usable: Mapping[str, PythonProject],
    manifests: set[str],
    siblings: Sequence[Mention],
) -> list[PythonProject]:
    """Return the projects after those of the tree that they need.

    That is by name, which pip would look for on its index, and what their modules import.
    """
    named = {canonicalize_name(p.name): p for p in usable.values() if p.name and p.folder not in manifests}
    found: dict[str, PythonProject] = {}
    seen: set[str] = set()

    def add(project: PythonProject) -> None:
        if project.folder in seen:
            return
        seen.add(project.folder)
        for asked in project.requirements:
            if asked.role == "" and not asked.url and asked.key in named:
                add(named[asked.key])
        for each in siblings:
            if project.folder and each.file.startswith(f"{project.folder}/"):
                add(usable[each.value])
        found[project.folder] = project

    for project in chosen:
        add(project)
    return list(found.values())


def _compiles(project: PythonProject) -> bool:
    """Tell whether a project compiles something, which the CMake of the same folder may do as well."""
    return bool(project.extensions) or not COMPILED_ON_IMPORT.isdisjoint(each.key for each in project.build_requires)


def _inside(folder: str, packages: set[str]) -> bool:
    """Tell whether a folder is or lies in a ROS package, whose build installs it."""
    parts = folder.split("/")
    return any("/".join(parts[:end]) in packages for end in range(len(parts), -1, -1))


def with_includes(evidence: Evidence, files: Iterable[RequirementFile]) -> list[RequirementFile]:
    """Return the files and all that they include."""
    by_path = {file.file: file for file in evidence.requirements}
    found: dict[str, RequirementFile] = {}
    pending = list(files)
    while pending:
        file = pending.pop(0)
        if file.file not in found:
            found[file.file] = file
            pending += [by_path[path] for path in file.includes if path in by_path]
    return list(found.values())


def files_of(evidence: Evidence, environment: CondaEnvironment) -> list[RequirementFile]:
    """Return the requirement files that the ``pip:`` part of an environment names."""
    paths = {path_of(each) for each in environment.requirements if each.role == "file"}
    return [file for file in evidence.requirements if file.file in paths]


def path_of(included: Requirement) -> str:
    """Return the path of a list that an environment includes: conda looks for it beside the environment's file."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(included.file), included.written))


def beside(evidence: Evidence, files: Sequence[RequirementFile], conda: str | None) -> tuple[str, ...]:
    """Return the files that must lie beside those that are installed: what they include, and their constraints."""
    chosen = [*files, *(file for e in evidence.conda if e.file == conda for file in files_of(evidence, e))]
    read = with_includes(evidence, chosen)
    return tuple(sorted({path for each in read for path in (each.file, *each.constraints)} - {f.file for f in files}))
