"""What the image runs when nothing is said."""

from __future__ import annotations

import posixpath
import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass

from roslab.config.model import Config, Kind
from roslab.decide.decision import Reason
from roslab.evidence import places
from roslab.evidence.facts import Evidence

MAX_CANDIDATES = 30
_WINDOWS = frozenset(
    {"PyQt5", "PyQt6", "PySide2", "PySide6", "tkinter", "Tkinter", "pygame", "wx", "pyglet", "vispy", "mayavi", "kivy"}
)
_PLACEHOLDER = re.compile(
    r"YOUR|your[_-]|path[/_-]to|/path|\[|\]|\.\.\.|…|/home/|~|\$|<|>|xxx|(?<![a-z])([a-z])\1{2,}(?![a-z])",
    re.IGNORECASE,
)
"""``yyy-yy`` too: a letter that is typed for want of a word."""
_ARGUMENT = re.compile(r"(?:^|[\s=])(?:\.{0,2}/|[\w.-]+/)|--help\b|(?:^|\s)-h\b|--show-args\b|\s(?:-s|--ros-args)$")
"""Files of the author's machine, or a question: no program to start by default."""
_TEST = re.compile(r"(?:^|[_-])(?:g?tests?|unittests?|bench(?:mark)?s?)(?:[_-]|$)", re.IGNORECASE)
_WORDS = {"ros2": 4, "roslaunch": 2, "rosrun": 3}
"""Words of the shortest command that starts something."""
_TOOLS = frozenset({"setup.py", "setup_db.py", "conftest.py", "get-pip.py", "download.py", "manage.py"})


@dataclass(frozen=True, kw_only=True, slots=True)
class CommandChoice:
    """A command (a string runs in ``bash -c``), what else it might have been, and whether it opens windows."""

    command: tuple[str, ...] | str = ("bash",)
    candidates: tuple[tuple[str, ...], ...] = ()
    gui: bool = False
    reasons: tuple[Reason, ...] = ()


@dataclass(frozen=True, kw_only=True, slots=True)
class _Candidate:
    argv: tuple[str, ...]
    why: str
    file: str
    line: int
    strong: bool
    """Somebody wrote that this is what one runs."""


def decide_command(evidence: Evidence, config: Config, kind: Kind, dockerfile: str | None) -> CommandChoice:
    """Return the default command: what roslab.yaml says, else the one obvious program, else a shell."""
    found: dict[tuple[str, ...], _Candidate] = {}
    for candidate in _candidates(evidence, kind):
        found.setdefault(candidate.argv, candidate)
    candidates = tuple(found)[:MAX_CANDIDATES]
    gui = config.gui if config.gui is not None else _gui(evidence)
    if config.command is not None:
        place = config.place("command")
        answer = config.command if isinstance(config.command, str) else shlex.join(config.command)
        said = Reason(
            question="command",
            answer=answer,
            reason="command says so",
            file=place.file if place else config.file,
            line=place.line if place else None,
            weight=100,
        )
        return CommandChoice(command=config.command, candidates=candidates, gui=gui, reasons=(said,))
    reasons = [
        Reason(
            question="command",
            answer=shlex.join(c.argv),
            reason=c.why,
            file=c.file,
            line=c.line,
            weight=20 if c.strong else 5,
            decisive=False,
        )
        for c in list(found.values())[:MAX_CANDIDATES]
    ]
    if dockerfile:
        authored = next((authored for authored in evidence.dockerfiles if authored.file == dockerfile), None)
        if authored and authored.command:
            own = Reason(
                question="command",
                answer=shlex.join(authored.command),
                reason="the author's Dockerfile starts it",
                file=authored.file,
                line=authored.command_line,
                weight=60,
            )
            return CommandChoice(command=authored.command, candidates=candidates, gui=gui, reasons=(own, *reasons))
    ours = [c for c in found.values() if _own(c.argv, evidence)]
    obvious = [c for c in ours if c.strong and not _ARGUMENT.search(" ".join(c.argv[2:]))]
    obvious = obvious if dockerfile or any(c.strong for c in ours) else ours
    obvious = _barest(obvious)
    if len(obvious) == 1 and not (obvious[0].strong and _others(evidence, obvious[0])):
        only = obvious[0]
        chosen = Reason(
            question="command",
            answer=shlex.join(only.argv),
            reason=f"the only one: {only.why}",
            file=only.file,
            line=only.line,
            weight=30,
        )
        return CommandChoice(command=only.argv, candidates=candidates, gui=gui, reasons=(chosen, *reasons))
    why = f"{len(found)} programs could be meant" if found else "no program stands out"
    shell = Reason(question="command", answer="bash", reason=f"{why}: a shell; set `command` in roslab.yaml", weight=10)
    return CommandChoice(candidates=candidates, gui=gui, reasons=(shell, *reasons))


def _own(argv: tuple[str, ...], evidence: Evidence) -> bool:
    """Tell whether a command starts something of the repository's: a viewer beside it is no default."""
    package = argv[2:3] if argv[0] == "ros2" else argv[1:2] if argv[0] in {"roslaunch", "rosrun"} else ()
    names = {manifest.name for manifest in evidence.manifests}
    return not package or not names or package[0] in names


def _others(evidence: Evidence, only: _Candidate) -> bool:
    """Tell whether the same page runs further Python files of the tree, which have no guard to be known by."""
    programs = [script.file for script in evidence.programs]
    folders = {file.rpartition("/")[0] for file in (*programs, *(d.file for d in evidence.code))} | {""}
    for mention in evidence.mentions:
        if mention.topic == "command" and mention.file == only.file and mention.value.startswith("python"):
            named = next((posixpath.normpath(p) for p in mention.value.split()[1:] if p.endswith(".py")), "setup.py")
            unknown = not any(program.endswith(named) for program in programs)
            if unknown and named.rpartition("/")[2] not in _TOOLS and named.rpartition("/")[0] in folders:
                return True
    return False


def _barest(candidates: list[_Candidate]) -> list[_Candidate]:
    """Keep of each program the call with the fewest arguments: variants of one call leave no doubt about it."""
    programs: dict[tuple[str, ...], _Candidate] = {}
    for candidate in candidates:
        argv = candidate.argv
        words = {"ros2": 4, "roslaunch": 3, "rosrun": 3}.get(argv[0], 2 if argv[1:2] != ("-m",) else 3)
        program = ("python3", *argv[1:words]) if argv[0].startswith("python") else argv[:words]
        known = programs.get(program)
        if known is None or len(argv) < len(known.argv):
            programs[program] = candidate
    return list(programs.values())


def _candidates(evidence: Evidence, kind: Kind) -> Iterator[_Candidate]:
    """Yield what could be run, what the README runs first."""
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
    """Tell whether the root is a CMake project that no tool of Python's knows."""
    manifests = [p.file for p in evidence.python] + [r.file for r in evidence.requirements]
    manifests += [environment.file for environment in evidence.conda]
    root = any(project.top_level and "/" not in project.file for project in evidence.cmake)
    return root and all("/" in file for file in manifests)


def _written(evidence: Evidence, *, ros: bool, compiled: bool) -> Iterator[_Candidate]:
    """Yield what READMEs run; a page deeper in the tree tells of a part, and a compiled program's scripts serve it."""
    programs = [script.file for script in evidence.programs]
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    said = [m for m in said if not places.vendored(m.file)]
    nearest = min((mention.file.count("/") for mention in said), default=0)
    for mention in said:
        argv = tuple(mention.value.split())
        if _PLACEHOLDER.search(mention.value) or any(part.rpartition("/")[2] in _TOOLS for part in argv):
            continue
        if len(argv) < _WORDS.get(argv[0], 1) or argv[-1].endswith(":="):
            continue  # a page's prose about the command, or an argument whose value it leaves to the reader
        if argv[0].startswith("python"):
            here = _here(argv, programs)
            if here is None:
                continue
            argv = ("python3" if ros else argv[0], *here)
            if compiled and _tests(here):
                continue
        elif not ros:
            continue
        strong = not any(places.example(part) for part in argv) and not (compiled and argv[0].startswith("python"))
        strong = strong and (ros or mention.file.count("/") == nearest) and not _tests(argv)
        yield _Candidate(argv=argv, why="the README runs it", file=mention.file, line=mention.line, strong=strong)


def _tests(argv: tuple[str, ...]) -> bool:
    """Tell whether a Python program only tests others."""
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


def _launched(evidence: Evidence) -> Iterator[_Candidate]:
    for launch in evidence.launch:
        if launch.package and not places.test(launch.file):
            start = ("roslaunch",) if launch.ros == 1 else ("ros2", "launch")
            argv = (*start, launch.package, launch.file.rpartition("/")[2])
            yield _Candidate(argv=argv, why="a launch file", file=launch.file, line=launch.line, strong=False)


def _compiled(evidence: Evidence) -> Iterator[_Candidate]:
    """Yield the programs of the top-level CMake project; its build folder is on the image's PATH."""
    for project in evidence.cmake:
        if project.top_level and not places.vendored(project.file) and project.file.count("/") <= 1:
            for target, line in project.executables:
                if re.fullmatch(r"[A-Za-z0-9_.+-]+", target) and not _TEST.search(target):
                    why = "a program that CMake compiles"
                    yield _Candidate(argv=(target,), why=why, file=project.file, line=line, strong=False)


def _installed(evidence: Evidence) -> Iterator[_Candidate]:
    for project in evidence.python:
        if not project.folder:
            for script, line in project.scripts:
                why = "a program that the project installs"
                yield _Candidate(argv=(script,), why=why, file=project.file, line=line, strong=False)
    for program in evidence.programs:
        path = program.file
        if program.kind == "main" and path.count("/") <= 1 and not places.vendored(path) and not places.example(path):
            why = "it has a __main__ guard"
            yield _Candidate(argv=("python3", path), why=why, file=path, line=program.line, strong=False)


def _gui(evidence: Evidence) -> bool:
    return any(launch.gui for launch in evidence.launch) or any(
        dependency.namespace == "import" and dependency.name in _WINDOWS and dependency.strength == "used"
        for dependency in evidence.code
    )
