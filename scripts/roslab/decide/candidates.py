"""The commands that could be the default: what the README runs, launch files, what is compiled or installed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterable, Iterator, Mapping

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate, launched_by, program_of
from roslab.decide.contained import contained
from roslab.decide.demanded_arguments import with_demands
from roslab.decide.first_command import helps
from roslab.decide.launch_calls import launch_calls
from roslab.decide.model_views import shows_model
from roslab.decide.notebook_server import served, server
from roslab.decide.programs import compiled as programs_of
from roslab.decide.programs import in_packages
from roslab.decide.purposes import names_of_whole
from roslab.decide.reasons import page_of
from roslab.decide.ros.without_manifest import by_cmake
from roslab.decide.ros.workspace import packages_of, types
from roslab.decide.sessions import in_sessions
from roslab.decide.shown_folders import in_shown_folder
from roslab.decide.startable_launches import unstartable
from roslab.decide.system.by_make import builds_all
from roslab.decide.system.switches import given
from roslab.decide.unmade_nodes import with_unmade
from roslab.decide.with_endings import with_endings
from roslab.decide.written_commands import written
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PackageManifest
from roslab.evidence.program import Program
from roslab.evidence.python_project import PythonProject
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

_TOOLS = pattern(r"(?:scripts?|tools?|utils?|bin|misc|dev|etc)/", re.IGNORECASE)
"""A folder whose programs serve a library, where no page runs them."""
_TRIALS = pattern(r"(?:debugs?|debugging|scratch|te?mp|playground)/", re.IGNORECASE)
"""A folder of trials, which do not compete with the programs beside it."""
_TESTS = pattern(r"(?:.*/)?(?:test_\w+|\w+_tests?|unittests?|run_?tests?)\.py", re.IGNORECASE)
"""A file of Python that tests the others; one called ``test.py`` may predict."""
_TEST = pattern(r"(?:^|[_-])(?:g?tests?|unittests?)(?:[_-]|$)", re.IGNORECASE)


def candidates_of(evidence: Evidence, kind: Kind) -> Iterator[Candidate]:
    """Yield what could be run; what the README runs comes first."""
    ros = kind in {"ros1", "ros2"}
    apart = ros and not evidence.launch and by_cmake(evidence) is not None  # its programs are no nodes of a package
    ros = ros and not apart
    compiled = apart or kind == "cpp" or (kind == "cuda" and _only_compiled(evidence))
    calls = launch_calls(evidence)
    files = {calls[each.file]: each for each in evidence.launch if each.file in calls}
    said = tuple(served(each, evidence) for each in written(evidence, kind, ros=ros, compiled=compiled))
    said = tuple(with_endings(said, evidence)) if ros else said
    unmade = with_unmade(evidence)
    names = tuple(names_of_whole(evidence))
    stops = [call for call, each in files.items() if each.idle or each.file in unmade]
    views = [call for call, each in files.items() if said and shows_model(each, evidence)]
    for each in said:
        told = with_demands(_below(each, evidence) if compiled else each, files)
        yield replace(told, unmade=_starts(each, stops), views=_starts(each, views), names=names)
    yield from contained(evidence, kind, compiled=compiled)
    yield from in_sessions(evidence, kind, compiled=compiled, written=any(each.strong for each in said))
    if not compiled and not any(each.strong for each in said):
        yield from _explained(evidence, ros=ros)
    if ros:
        launched = tuple(_launched(evidence, kind, calls))
        nodes = tuple(_nodes(evidence, kind))
        vain = unstartable(evidence, programs=bool(nodes)) if launched else frozenset()
        behind = unmade | {each.file for each in launched if places.left_behind(each.file)}
        vain |= behind if any(each.file not in vain | behind for each in launched) else frozenset()
        yield from (replace(each, cut=True) if each.file in vain else with_demands(each, files) for each in launched)
        yield from nodes if all(each.file in vain for each in launched) else ()
        yield from () if launched or nodes else in_shown_folder(evidence, kind)
    elif compiled:
        yield from (_below(each, evidence) for each in _compiled(evidence))
        yield from _made(evidence)
    else:
        yield from _installed(evidence, examples=not said) if evidence.programs else of_notebooks(evidence)
        yield from in_shown_folder(evidence, kind)


def once(found: Iterable[Candidate]) -> Iterator[Candidate]:
    """Yield the commands without those that only a file suggests where an earlier one starts that program.

    Any Python counts as the same: ``python X`` and ``python3 X``.
    """
    programs: set[tuple[str, ...]] = set()
    for each in found:
        program = program_of(each.argv)
        if each.strong or program not in programs or program[0] != "python3":
            yield each
        programs.add(program)


def _explained(evidence: Evidence, *, ros: bool) -> Iterator[Candidate]:
    """Yield the programs of Python that a page at the root says are meant; beside nodes, none that it only offers."""
    for said in evidence.mentions:
        if said.topic != "pointed":
            continue
        from roslab.evidence.prose.pointed import offered  # noqa: PLC0415 - few pages say it

        if ros and offered(said.text, said.value):
            continue
        if said.value.endswith(".py") and not said.value.endswith(".launch.py"):
            yield Candidate(
                argv=("python3", said.value),
                why=f"{page_of(said.file)} tells what it is for",
                file=said.file,
                line=said.line,
                strong=True,
                heading=said.heading,
            )


def _starts(candidate: Candidate, calls: Collection[tuple[str, ...]]) -> bool:
    """Tell whether a command starts one of the launch files with these calls."""
    rest = launched_by(candidate.argv)
    return rest[:1] in calls or rest[:2] in calls


def _below(candidate: Candidate, evidence: Evidence) -> Candidate:
    """Return a compiled program as one that starts in a folder of the tree, if it opens others from there: ``../data``.

    Any folder beside the build folder will do, which the image does not have.
    """
    opens = {m.text: m.value for m in evidence.mentions if m.topic == "above"}
    folder = "" if candidate.inside else opens.get(candidate.argv[0], "")
    return replace(candidate, inside=folder) if folder else candidate


def _only_compiled(evidence: Evidence) -> bool:
    """Tell whether the root is a project of CMake or make and no Python project."""
    manifests = [p.file for p in evidence.python if not p.folder]  # what a page clones is a folder
    manifests += [each.file for each in evidence.requirements]
    manifests += [environment.file for environment in evidence.conda]
    root = any(project.top_level and "/" not in project.file for project in evidence.cmake)
    root = root or any(not made.folder for made in evidence.makefiles)
    return root and all("/" in file for file in manifests)


def _launched(evidence: Evidence, kind: Kind, calls: Mapping[str, tuple[str, ...]]) -> Iterator[Candidate]:
    """Yield the launch files of the repository's packages that are for its version of ROS."""
    tests = {test.file for test in evidence.tests} | {launch.file for launch in evidence.launch if launch.tests}
    for launch in evidence.launch:
        aside = launch.file in tests or places.test(launch.file) or not launch.installed
        if launch.package and not aside and kind == f"ros{launch.ros}":
            start = ("roslaunch",) if launch.ros == 1 else ("ros2", "launch")
            argv = (*start, *calls[launch.file])
            why = "a launch file, which its package does not install" if launch.by_path else "a launch file"
            yield Candidate(argv=argv, why=why, file=launch.file, line=launch.line, strong=False)


def _nodes(evidence: Evidence, kind: Kind) -> Iterator[Candidate]:
    """Yield the programs that the packages compile or install, for a repository without launch files to start."""
    start = ("rosrun",) if kind == "ros1" else ("ros2", "run")
    packages = in_packages(evidence, kind)
    for project in evidence.cmake:
        for name, line in project.executables:
            if (package := packages.get(name)) and not _TEST.search(name) and not places.aside(project.file):
                why = "a program that its package compiles"
                yield Candidate(argv=(*start, package, name), why=why, file=project.file, line=line, strong=False)
    by_cmake = {project.file.rpartition("/")[0] for project in evidence.cmake}
    made = {manifest.file.rpartition("/")[0]: manifest for manifest in packages_of(evidence).built}
    for python in evidence.python if kind == "ros2" else ():
        manifest = made.get(python.folder)
        if manifest is None or not manifest.name or (python.folder in by_cmake and not _by_python(python, manifest)):
            continue
        for name, line in python.scripts:
            why = "a program that its package installs"
            argv = (*start, manifest.name, name)
            yield Candidate(argv=argv, why=why, file=python.file, line=line, strong=False)


def _by_python(project: PythonProject, manifest: PackageManifest) -> bool:
    """Tell whether colcon installs the programs of a project beside a CMakeLists.txt where ``ros2 run`` looks for them.

    It does where Python builds the package; ament_cmake reads a setup.cfg, and neither setup.py nor pyproject.toml.
    https://github.com/ament/ament_cmake (ament_cmake_python/cmake/ament_python_install_package.cmake), 2026-11-27.
    """
    return "ament_python" in types(manifest, 2) or project.file.endswith("setup.cfg")


def _compiled(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the programs of the top-level CMake project; the folders that hold them are on the image's PATH.

    Not those that wait for an option that is off, and no examples that wait for one, unless a page at the root sets it.
    """
    left_out = set(_left_out(evidence))
    for program in programs_of(evidence):
        if (program.file, program.name) in left_out:
            continue
        why = "a program that CMake compiles"
        yield Candidate(argv=(program.name,), why=why, file=program.file, line=program.line, strong=False)


def _made(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the one program of the Makefile that is the whole project, or the only one, in a folder of the tree."""
    lone = evidence.makefiles[0] if len(evidence.makefiles) == 1 else None
    made = builds_all(evidence) or (lone if lone and lone.folder and not (lone.script or lone.qt) else None)
    if made and made.only:
        why, program = "a program that make compiles", posixpath.join(made.folder, made.only)
        yield Candidate(argv=(f"./{program}",), why=why, file=made.file, line=made.line, strong=False)


def _left_out(evidence: Evidence) -> Iterator[tuple[str, str]]:
    """Yield the programs that wait for an option, each with its file, which nobody sets."""
    options = given(evidence)
    for project in evidence.cmake:
        for name, variable in project.optional:
            off = variable.startswith("OFF ") or places.example(project.file)
            if off and f"-D{variable.removeprefix('OFF ')}" not in options:
                yield project.file, name


def of_notebooks(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the server of the notebooks that a tree consists of, where neither a program nor a package is beside them.

    It opens the one notebook, of several the folder.
    """
    library = any(project.meant for project in evidence.python)
    if evidence.notebooks and not (evidence.programs or library):
        opened = evidence.notebooks if len(evidence.notebooks) == 1 else ()
        why = "the tree consists of notebooks"
        yield Candidate(argv=(*server(evidence), *opened), why=why, file=evidence.notebooks[0], line=1, strong=False)


def _installed(evidence: Evidence, *, examples: bool) -> Iterator[Candidate]:
    """Yield the programs that the project installs, then the files that are made to be run.

    Where there are none, the ``examples``, of which none is meant before the others. What a package starts by its name
    is what the programs that are installed with it do.
    """
    found = False
    for project in evidence.python:
        if not project.folder:
            for script, line in project.scripts:
                found = True
                why = "a program that the project installs"
                yield Candidate(argv=(script,), why=why, file=project.file, line=line, strong=False)
    scripts = found
    library = any(project.meant and not project.folder and project.requirements for project in evidence.python)
    installed = any(project.installable and not project.folder for project in evidence.python)
    imported = {(m.file, m.value) for m in evidence.mentions if m.topic == "from_root"}
    tests = {program.file for program in evidence.programs if _TESTS.fullmatch(program.file)}
    whole = any(program.kind == "main" and "/" not in program.file for program in evidence.programs)
    shown, behind = [], []
    for program in sorted(evidence.programs, key=lambda program: program.imported):
        path = program.file
        if path in tests and len(tests) < len(evidence.programs):
            continue
        aside = places.vendored(path) or (library and _TOOLS.match(path))
        words = _words(program, imported, installed=installed)
        if program.kind == "main" and words and not aside:
            argv, why = ("python3", *words), _why(program)
            each = Candidate(argv=argv, why=why, file=path, line=program.line, strong=False, inside=program.inside)
            if program.relative and not program.module:
                behind.append(each)
            elif places.example(path):
                shown.append(replace(each, cut=True))
            elif (
                (scripts and program.module) or (whole and _TRIALS.match(path)) or (not program.guarded and helps(each))
            ):
                yield replace(each, cut=True)
            else:
                found = True
                yield each
    yield from shown if examples and not found else ()
    yield from (replace(each, cut=True) if found or shown else each for each in behind)


def _why(program: Program) -> str:
    if program.module:
        return f"the __main__.py of {program.module}"
    return "it has a __main__ guard" if program.guarded else "it is called like a program, and its statements run"


def _words(program: Program, imported: Collection[tuple[str, str]], *, installed: bool) -> tuple[str, ...]:
    """Return what Python is given to start a program at the root or in a folder there, ``()`` for one further down.

    A package is started by its name, one of ``src`` where pip installs the whole (``installed``), and so is a module
    with relative imports.
    """
    path = program.file
    if program.module and "." not in program.module and (installed or path.count("/") == 1):
        return ("-m", program.module)
    if path.count("/") > 1:
        return ()
    if program.relative:
        words = _as_module(path)
        return words if "/" in path and words[0] == "-m" else ()
    return _as_module(path) if (path, path.partition("/")[0]) in imported else (path,)


def _as_module(path: str) -> tuple[str, ...]:
    """Return the words that start a file which imports the package that it lies in: Python finds that from the root."""
    name = path.removesuffix(".py").replace("/", ".")
    return ("-m", name) if all(map(str.isidentifier, name.split("."))) else (path,)
