"""The commands that could be the default: what the README runs, launch files, what is compiled or installed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from roslab.config.model import Kind
from roslab.decide.programs import compiled as programs_of
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention

_PLACEHOLDER = re.compile(
    r"YOUR|your[_-]|path[/_-]to|/path|\[|\]|\.\.\.|…|/home/|~|\$|<|>|xxx|(?<![a-z])([a-z])\1{2,}(?![a-z])",
    re.IGNORECASE,
)
"""Also ``yyy-yy``: a repeated letter stands for a value that the reader fills in."""
_NUMBERS = re.compile(r"\[[.,\s-]*\d[\d.,\s-]*\]")
"""A list of numbers: ``--hid [32,32]``."""
_WORDS = {"ros2": 4, "roslaunch": 2, "rosrun": 3}
"""Fewest words of a command that starts something."""
_LAUNCH = re.compile(r"\.launch(?:\.(?:py|xml|ya?ml))?$|_launch\.(?:py|xml|ya?ml)$")
TOOLS = frozenset({"setup.py", "setup_db.py", "conftest.py", "get-pip.py", "download.py", "manage.py"})
"""Files that serve a project without being its purpose."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Candidate:
    """A command that starts something, and where it was found."""

    argv: tuple[str, ...]
    why: str
    file: str
    line: int
    strong: bool
    """The author's text says to run it."""
    heading: str = ""
    """The titles of the sections of the page that run it."""
    files: tuple[str, ...] = ()
    """Arguments that the tree has."""


def candidates_of(evidence: Evidence, kind: Kind) -> Iterator[Candidate]:
    """Yield what could be run; what the README runs comes first."""
    ros = kind in {"ros1", "ros2"}
    compiled = kind == "cpp" or (kind == "cuda" and _only_compiled(evidence))
    yield from _written(evidence, kind, ros=ros, compiled=compiled)
    if ros:
        yield from _launched(evidence, kind)
    elif compiled or not evidence.programs:
        yield from _compiled(evidence)
    else:
        yield from _installed(evidence)


def _only_compiled(evidence: Evidence) -> bool:
    """Tell whether the root is a CMake project and no Python project."""
    manifests = [p.file for p in evidence.python] + [r.file for r in evidence.requirements]
    manifests += [environment.file for environment in evidence.conda]
    root = any(project.top_level and "/" not in project.file for project in evidence.cmake)
    return root and all("/" in file for file in manifests)


def _written(evidence: Evidence, kind: Kind, *, ros: bool, compiled: bool) -> Iterator[Candidate]:
    """Yield what READMEs run; a subfolder's page, examples and helper scripts of compiled code are weaker."""
    tree = _Tree(
        kind=kind,
        programs=tuple(script.file for script in evidence.programs),
        compiled=_in_packages(evidence) if ros else dict.fromkeys((p.name for p in programs_of(evidence)), ""),
        launched=_launch_files(evidence),
        packages=packages_of(evidence).names,
        tasks={name: command for environment in evidence.conda for name, command, _ in environment.tasks},
    )
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    said = [m for m in said if not places.vendored(m.file)]
    nearest = min((mention.file.count("/") for mention in said), default=0)
    for mention in said:
        argv = _runnable(mention, tree, ros=ros, compiled=compiled)
        if argv is not None:
            strong = not compiled or not any(places.example(part) for part in argv[:2])
            strong = strong and not (compiled and argv[0].startswith("python"))
            strong = strong and (ros or mention.file.count("/") == nearest) and not _tests(argv)
            yield Candidate(
                argv=argv,
                why="the README runs it",
                file=mention.file,
                line=mention.line,
                strong=strong,
                heading=mention.heading,
                files=mention.files,
            )


@dataclass(frozen=True, kw_only=True, slots=True)
class _Tree:
    """What the tree has to start."""

    kind: Kind
    programs: tuple[str, ...]
    compiled: Mapping[str, str]
    """Compiled programs, each with its package, ``""`` where there is none."""
    launched: Mapping[str, frozenset[str]]
    """The launch files of each package, by their names."""
    packages: frozenset[str]
    tasks: Mapping[str, str]
    """pixi's, by their names."""


def _in_packages(evidence: Evidence) -> dict[str, str]:
    """Return the programs that the CMakeLists.txt of each package compiles; of a name that two packages have, none."""
    folders = {manifest.file.rpartition("/")[0]: manifest.name for manifest in packages_of(evidence).built}
    found: dict[str, str] = {}
    twice: set[str] = set()
    for project in evidence.cmake:
        package = _owner(project.file, folders)
        for name, _ in project.executables if package else ():
            if found.setdefault(name, package or "") != package:
                twice.add(name)
    return {name: package for name, package in found.items() if name not in twice}


def _owner(path: str, folders: Mapping[str, str | None]) -> str | None:
    """Return the package that a file lies in, at any depth."""
    while path:
        path = path.rpartition("/")[0]
        if path in folders:
            return folders[path]
    return None


def _launch_files(evidence: Evidence) -> dict[str, frozenset[str]]:
    found: dict[str, set[str]] = {}
    for launch in evidence.launch:
        found.setdefault(launch.package or "", set()).add(launch.file.rpartition("/")[2])
    return {package: frozenset(names) for package, names in found.items()}


def _runnable(mention: Mention, tree: _Tree, *, ros: bool, compiled: bool) -> tuple[str, ...] | None:
    """Return the argv of a command as it can be run from the root; ``None`` if it starts nothing from the tree."""
    argv = _task(tuple(mention.value.split()), tree)
    if _PLACEHOLDER.search(_NUMBERS.sub("", mention.value)) or any(part.rpartition("/")[2] in TOOLS for part in argv):
        return None
    if len(argv) < _WORDS.get(argv[0], 1) or argv[-1].endswith(":="):
        return None  # a sentence about the command, or a placeholder for the reader to fill in
    if argv[0] in _WORDS:
        return _of_ros(argv, tree) if ros else None
    if not argv[0].startswith("python"):
        return _shell(argv, mention) if not ros and not compiled else _built(argv, tree)
    named = (file for file in mention.files if file.endswith(".py"))  # a script needs no guard to be run
    here = _here(argv, tuple(dict.fromkeys((*tree.programs, *named))))
    if here is None or (compiled and _tests(here)):
        return None
    return ("python3" if ros else argv[0], *here)


def _task(argv: tuple[str, ...], tree: _Tree) -> tuple[str, ...]:
    """Return what ``pixi run TASK`` starts; other commands as they are."""
    if argv[:2] != ("pixi", "run") or len(argv) < 3:
        return argv
    command = tree.tasks.get(argv[2], "")
    words = command.split() if not re.search(r"[&|;$]", command) else []
    while words and re.fullmatch(r"\w+=\S*", words[0]):
        words = words[1:]
    return (*words, *argv[3:]) if words else argv


def _shell(argv: tuple[str, ...], mention: Mention) -> tuple[str, ...] | None:
    """Return the call of a shell script of the tree: ``sh run.sh``, ``./run.sh``."""
    script = argv[1:] if argv[0] in {"bash", "sh"} else argv
    known = bool(script) and script[0] in mention.files and script[0].endswith(".sh")
    return ("bash", *script) if known else None


def _of_ros(argv: tuple[str, ...], tree: _Tree) -> tuple[str, ...] | None:
    """Return a command of the repository's ROS version; ``None`` if its launch file is not in the tree.

    ``roslaunch path/to/a.launch`` becomes ``roslaunch PACKAGE a.launch``.
    """
    if (argv[0] == "ros2") != (tree.kind == "ros2"):
        return None
    start = argv[:1] if argv[0] == "roslaunch" else argv[:2] if argv[1:2] == ("launch",) else ()
    if not start:
        return argv
    package, *rest = argv[len(start) :]
    if _LAUNCH.search(package):
        name = package.rpartition("/")[2]
        owners = [owner for owner, names in tree.launched.items() if owner and name in names]
        return (*start, owners[0], name, *rest) if len(owners) == 1 else None
    if package not in tree.packages:
        return argv
    file = next((word.rpartition("/")[2] for word in rest if not word.startswith("-")), "")
    return argv if file in tree.launched.get(package, ()) else None


def _built(argv: tuple[str, ...], tree: _Tree) -> tuple[str, ...] | None:
    """Return the call of a compiled program by its name: ``./build/align a`` becomes ``align a``."""
    name = argv[0].rpartition("/")[2]
    if name not in tree.compiled:
        return None
    if not (package := tree.compiled[name]):
        return (name, *argv[1:])
    return ("rosrun", package, name, *argv[1:]) if tree.kind == "ros1" else ("ros2", "run", package, name, *argv[1:])


def _tests(argv: tuple[str, ...]) -> bool:
    """Tell whether a command only runs tests or benchmarks."""
    programs = [part for part in argv if part.endswith(".py")]
    return any(part.endswith("_test.py") or places.test(part) for part in programs)


def _here(argv: tuple[str, ...], programs: tuple[str, ...]) -> tuple[str, ...] | None:
    """Return the arguments of a Python that runs a program of the tree, its path from the root; else ``None``."""
    if argv[1:2] == ("-m",):
        module = argv[2].replace(".", "/") if len(argv) > 2 else ""
        return argv[1:] if {f"{module}.py", f"{module}/__main__.py"} & set(programs) else None
    for position, part in enumerate(argv[1:], 1):
        if part.endswith(".py"):
            path = posixpath.normpath(part)
            ends = [path] if path in programs else [program for program in programs if program.endswith("/" + path)]
            return (*argv[1:position], ends[0], *argv[position + 1 :]) if len(ends) == 1 else None
    return None


def _launched(evidence: Evidence, kind: Kind) -> Iterator[Candidate]:
    """Yield the launch files of the repository's packages that are for its version of ROS."""
    for launch in evidence.launch:
        if launch.package and not places.test(launch.file) and kind == f"ros{launch.ros}":
            start = ("roslaunch",) if launch.ros == 1 else ("ros2", "launch")
            argv = (*start, launch.package, launch.file.rpartition("/")[2])
            yield Candidate(argv=argv, why="a launch file", file=launch.file, line=launch.line, strong=False)


def _compiled(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the programs of the top-level CMake project; the folders that hold them are on the image's PATH."""
    for program in programs_of(evidence):
        why = "a program that CMake compiles"
        yield Candidate(argv=(program.name,), why=why, file=program.file, line=program.line, strong=False)


def _installed(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the programs that the project installs, then the files that are made to be run."""
    for project in evidence.python:
        if not project.folder:
            for script, line in project.scripts:
                why = "a program that the project installs"
                yield Candidate(argv=(script,), why=why, file=project.file, line=line, strong=False)
    for program in evidence.programs:
        path = program.file
        if program.kind == "main" and path.count("/") <= 1 and not places.vendored(path) and not places.example(path):
            why = "it has a __main__ guard"
            yield Candidate(argv=("python3", path), why=why, file=path, line=program.line, strong=False)
