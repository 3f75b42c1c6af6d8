"""The commands that could be the default: what the README runs, launch files, what is compiled or installed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from dataclasses import dataclass

from roslab.config.model import Kind
from roslab.evidence import places
from roslab.evidence.facts import Evidence

_PLACEHOLDER = re.compile(
    r"YOUR|your[_-]|path[/_-]to|/path|\[|\]|\.\.\.|…|/home/|~|\$|<|>|xxx|(?<![a-z])([a-z])\1{2,}(?![a-z])",
    re.IGNORECASE,
)
"""Also ``yyy-yy``: a repeated letter stands for a value that the reader fills in."""
_TEST = re.compile(r"(?:^|[_-])(?:g?tests?|unittests?|bench(?:mark)?s?)(?:[_-]|$)", re.IGNORECASE)
_WORDS = {"ros2": 4, "roslaunch": 2, "rosrun": 3}
"""Fewest words of a command that starts something."""
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


def candidates_of(evidence: Evidence, kind: Kind) -> Iterator[Candidate]:
    """Yield what could be run; what the README runs comes first."""
    ros = kind in {"ros1", "ros2"}
    compiled = kind == "cpp" or (kind == "cuda" and _only_compiled(evidence))
    yield from _written(evidence, ros=ros, compiled=compiled)
    if ros:
        yield from _launched(evidence)
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


def _written(evidence: Evidence, *, ros: bool, compiled: bool) -> Iterator[Candidate]:
    """Yield what READMEs run; a subfolder's page, examples and helper scripts of compiled code are weaker."""
    programs = [script.file for script in evidence.programs]
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    said = [m for m in said if not places.vendored(m.file)]
    nearest = min((mention.file.count("/") for mention in said), default=0)
    for mention in said:
        argv = _runnable(mention.value, programs, ros=ros, compiled=compiled)
        if argv is not None:
            strong = not any(places.example(part) for part in argv) and not (compiled and argv[0].startswith("python"))
            strong = strong and (ros or mention.file.count("/") == nearest) and not _tests(argv)
            yield Candidate(argv=argv, why="the README runs it", file=mention.file, line=mention.line, strong=strong)


def _runnable(text: str, programs: list[str], *, ros: bool, compiled: bool) -> tuple[str, ...] | None:
    """Return the argv of a command as it can be run from the root; ``None`` if it starts nothing from the tree."""
    argv = tuple(text.split())
    if _PLACEHOLDER.search(text) or any(part.rpartition("/")[2] in TOOLS for part in argv):
        return None
    if len(argv) < _WORDS.get(argv[0], 1) or argv[-1].endswith(":="):
        return None  # a sentence about the command, or a placeholder for the reader to fill in
    if not argv[0].startswith("python"):
        return argv if ros else None
    here = _here(argv, programs)
    if here is None or (compiled and _tests(here)):
        return None
    return ("python3" if ros else argv[0], *here)


def _tests(argv: tuple[str, ...]) -> bool:
    """Tell whether a command only runs tests or benchmarks."""
    programs = [part for part in argv if part.endswith(".py")]
    return any(part.endswith("_test.py") or places.test(part) for part in programs)


def _here(argv: tuple[str, ...], programs: list[str]) -> tuple[str, ...] | None:
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


def _launched(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the launch files of the repository's packages."""
    for launch in evidence.launch:
        if launch.package and not places.test(launch.file):
            start = ("roslaunch",) if launch.ros == 1 else ("ros2", "launch")
            argv = (*start, launch.package, launch.file.rpartition("/")[2])
            yield Candidate(argv=argv, why="a launch file", file=launch.file, line=launch.line, strong=False)


def _compiled(evidence: Evidence) -> Iterator[Candidate]:
    """Yield the programs of the top-level CMake project; its build folder is on the image's PATH."""
    for project in evidence.cmake:
        if project.top_level and not places.vendored(project.file) and project.file.count("/") <= 1:
            for target, line in project.executables:
                if re.fullmatch(r"[A-Za-z0-9_.+-]+", target) and not _TEST.search(target):
                    why = "a program that CMake compiles"
                    yield Candidate(argv=(target,), why=why, file=project.file, line=line, strong=False)


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
