"""The commands that the pages of a repository run, as they can be run from its root."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping

from roslab.config.model import Kind
from roslab.decide.blank_launches import BLANK, LAUNCH, pointed_launches, with_a_launch_file, with_the_one_named
from roslab.decide.candidate import Candidate, is_component, program_of
from roslab.decide.launch_calls import call_of, launch_calls
from roslab.decide.outputs import written_below
from roslab.decide.programs import compiled as programs_of
from roslab.decide.programs import in_packages
from roslab.decide.ros.workspace import packages_of
from roslab.decide.scripts import bare, script_of, task_of
from roslab.decide.sections import about_trouble
from roslab.decide.simulators import simulators_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose import copies
from roslab.evidence.prose.runners import SIMULATORS
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern
from roslab.values.words import written as as_written

_PLACEHOLDER = pattern(
    r"YOUR|your[_-]|path[/_-]to|/path|/where/|\[|\]|\.\.\.|…|/home/|~|\$|<|>|\{[a-z]\w*\}|xxx|(?<![a-z])([a-z])\1{2,}(?![a-z])|"
    r"(?-i:(?<![A-Za-z])XX(?![A-Za-z])|/[A-Z_]{5,}(?:\.\w+)?$|(?:=|^)[A-Z_]+_(?:NAME|PATH|DIR|FILE|FOLDER|ID|IP|ROOT|LOCATION)$)|"
    r"^-{0,2}(?:[\w-]+=)?\w*[_-]\*$",
    re.IGNORECASE,
)
"""Also ``yyy-yy``, as a repeated letter stands for a value that the reader fills in, ``name:=PACKAGE_NAME``, and
``--config-name=train_*``: what a shell would fill in has a folder or an ending, ``data/*.png``."""
_BRACKETS = pattern(r"<[^<>]{1,80}>|\[[^\[\]]{1,80}\]|\$\([^()]{1,80}\)")
"""A blank of several words: ``<path to the data>``, ``[--option VALUE]``, ``$(rospack find demo)``."""
_OPTIONAL = pattern(r"\[\s*(?:-|\w+:=)")
_NUMBERS = pattern(r"\[[.,\s-]*\d[\d.,\s-]*\]")
"""A list of numbers: ``--hid [32,32]``."""
_PATHS = pattern(r"(?<==)\[([\w.:-]*/[\w./:,-]+)\]")
"""A list of paths that Hydra is given: ``models=[out/a.pth,out/b.pth]``."""
_NAMED_VALUE = pattern(r"([\w-]+) \1[_-](?:name|id|path|dir|folder|file)", re.IGNORECASE)
"""An option and a value that only says what it is: ``--algo algo_name``."""
_SAYS_WHAT = pattern(r"(?:^|=)[a-z]+(?:_[a-z]+)*_(?:path|dir|directory|folder|filename|file|name)$")
"""A value that only says what belongs there: ``log_file_path``, ``map:=map_name``."""
_STANDS_FOR = pattern(
    r"(?:^|=)(?:CONFIG|FILE|INPUT|OUTPUT|IMAGE|VIDEO|MODEL|CHECKPOINT|DATASET)(?:_(?:FILE|NAME))?\.\w{1,5}$"
)
"""A file of the reader's own, where the tree has none of that name: ``CONFIG.yaml``."""
_KEY = pattern(r"[A-Z][A-Z0-9_]*(?:\.[A-Z][A-Z0-9_]*)+")
"""A key of yacs, whose value is the next word: ``MODEL.WEIGHTS a.pth``."""
_WORDS = {"ros2": 4, "roslaunch": 2, "rosrun": 3}
"""Fewest words of a command that starts something."""
_BESIDE = pattern(r"\./[\w.+-]+")
_ABOVE = pattern(r"^(--?[\w-]+=)?(?:\.\./)+(?=[\w-])")
TOOLS = frozenset({"setup.py", "setup_db.py", "conftest.py", "get-pip.py", "download.py", "manage.py"})
"""Files that serve a project without being its purpose."""


def written(evidence: Evidence, kind: Kind, *, ros: bool, compiled: bool) -> tuple[Candidate, ...]:
    """Return what READMEs run; a subfolder's page, examples and helper scripts of compiled code are weaker.

    So is a file of Python that no package has, beside nodes or on a page below the root of a repository of ROS.
    """
    found = tuple(_said(evidence, kind, ros=ros, compiled=compiled))
    nodes = ros and any(each.strong and not each.argv[0].startswith("python") for each in found)
    folders = tuple(f"{m.file.rpartition('/')[0]}/" for m in packages_of(evidence).built if "/" in m.file)
    lone = [c.argv[0].startswith("python") and not c.argv[1].startswith(folders) for c in found]
    weak = [(nodes or (ros and "/" in c.file)) and outside for c, outside in zip(found, lone, strict=True)]
    return tuple(replace(c, strong=False) if outside else c for c, outside in zip(found, weak, strict=True))


def _said(evidence: Evidence, kind: Kind, *, ros: bool, compiled: bool) -> Iterator[Candidate]:
    tree = _Tree(
        kind=kind,
        programs=tuple(script.file for script in evidence.programs),
        compiled=in_packages(evidence) if ros else dict.fromkeys((p.name for p in programs_of(evidence)), ""),
        launched=_launch_files(evidence),
        calls=launch_calls(evidence),
        alone=frozenset(each.file for each in evidence.launch if not each.package),
        simulators=simulators_of(evidence),
        packages=packages_of(evidence).names,
        installed=frozenset(name for project in evidence.python if project.installable for name, _ in project.scripts),
        projects=tuple(project.folder for project in evidence.python if project.installable),
        made={name: each.folder for each in evidence.makefiles if compiled for name in each.programs},
        tasks={name: command for environment in evidence.conda for name, command, _ in environment.tasks},
    )
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    said = [m for m in said if not (places.vendored(m.file) or about_trouble(m.heading))]
    fetching = {m.inside for m in evidence.mentions if m.topic == "fetched" and m.inside}
    pointed = pointed_launches(evidence)
    beside = tree.compiled if kind == "cpp" else {}  # programs that a page starts in its build folder
    nearest = min((mention.file.count("/") for mention in said), default=0)
    for mention in said:
        whole, cut, blanks = _filled(mention.value, mention.files)
        whole = with_the_one_named(whole, mention, pointed)
        argv = _runnable(whole, mention, tree, ros=ros, compiled=compiled)
        if argv is not None and not fetching & {*argv[:2]}:
            strong = not compiled or not any(places.example(part) for part in argv[:2])
            strong = strong and not (compiled and argv[0].startswith("python"))
            strong = strong and (ros or mention.file.count("/") == nearest) and not _tests(argv)
            strong = strong and not copies.below(mention.file, evidence.copies)
            yield Candidate(
                argv=tuple(map(as_written, argv)),
                why="the README runs it",
                file=mention.file,
                line=mention.line,
                strong=strong,
                heading=mention.heading,
                files=mention.files,
                inside=mention.inside if argv[0].startswith(("python", "bash")) or argv[0] in beside else "",
                cut=cut,
                blanks=blanks,
                variables=mention.variables,
                installed=argv[0] in tree.installed and not ros,
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
    calls: Mapping[str, tuple[str, ...]]
    """How each launch file of the tree is started, by its path."""
    alone: frozenset[str]
    """Launch files that belong to no package."""
    simulators: frozenset[str]
    packages: frozenset[str]
    installed: frozenset[str]
    """Programs that pip installs with the repository."""
    projects: tuple[str, ...]
    """Folders that pip installs."""
    tasks: Mapping[str, str]
    """pixi's, by their names."""
    made: Mapping[str, str]
    """Programs that a Makefile may compile, each with its folder."""


def _launch_files(evidence: Evidence) -> dict[str, frozenset[str]]:
    found: dict[str, set[str]] = {}
    for launch in evidence.launch:
        found.setdefault(launch.package or "", set()).add(launch.file.rpartition("/")[2])
    return {package: frozenset(names) for package, names in found.items()}


def _filled(command: str, files: tuple[str, ...]) -> tuple[tuple[str, ...], bool, tuple[str, ...]]:
    """Return the words of a command without the values that the reader fills in, whether that leaves a gap, and names.

    ``map:=PATH`` is left out whole, as the launch file may have a default, and its name returned; an option goes with
    its value, and what follows an argument that is left out, with it. Words that name the program stay, and so do
    ``files``, which the tree has.
    """
    kept: list[str] = []
    blanks: list[str] = []
    gap = positional = False
    words = _BRACKETS.sub(_blank, command).split()
    for said in words[1:] if words[:1] == words[1:2] else words:  # ``roslaunch roslaunch``
        word = written_below(kept[-1] if kept else "", said)
        blank = bool(_PLACEHOLDER.search(_PATHS.sub(r"\1", _NUMBERS.sub("", word)))) or word.endswith(":=")
        value = bool(kept) and kept[-1].startswith("-") and not word.startswith("-")
        blank = blank or (value and bool(_NAMED_VALUE.fullmatch(f"{kept[-1].lstrip('-')} {word}")))
        unknown = word not in files and bool(_SAYS_WHAT.search(word) or _STANDS_FOR.search(word))
        blank = blank or (value and word in {"N", "X"}) or unknown
        if not _named(kept) or not (blank or (positional and not value and word[:1] != "-")):
            kept.append(word)
            continue
        keyed = _named(kept[:-1]) and bool(_KEY.fullmatch(kept[-1])) and "=" not in word
        if keyed or (value and (":=" not in word or kept[-1] in {"-p", "-r"})):
            kept.pop()  # the option goes with it: ``-p map:=PATH``, and ``MODEL.WEIGHTS PATH``
        if ":=" not in word:
            gap = True
            positional = positional or not (value or keyed or word.startswith("-"))
        else:
            blanks.append(word.partition(":=")[0])
    return tuple(kept), gap, tuple(blanks)


def _blank(match: re.Match[str]) -> str:
    """Return a blank without its words, nothing for an argument that may be left out: ``[rviz:=true]``."""
    if _NUMBERS.fullmatch(match[0]) or _PATHS.match(match.string, match.start()):
        return match[0]
    return "" if _OPTIONAL.match(match[0]) else BLANK


def _named(words: list[str]) -> bool:
    """Tell whether the first words of a command name its program."""
    if words and words[0].startswith("python"):
        return any(word.endswith(".py") for word in words) or "-m" in words[:-1]
    fewest = {"roslaunch": 3, "rosrun": 3, "ros2": 4, "bash": 2, "sh": 2}.get((words or [""])[0], 1)
    return len(words) >= fewest + is_component(words)


def _runnable(
    words: tuple[str, ...], mention: Mention, tree: _Tree, *, ros: bool, compiled: bool
) -> tuple[str, ...] | None:
    """Return the argv of a command as it can be run from the root; ``None`` if it starts nothing from the tree."""
    argv = with_a_launch_file(task_of(words, tree.tasks), tree.launched)
    if not argv or any(map(_PLACEHOLDER.search, program_of(argv))) or any(p.rpartition("/")[2] in TOOLS for p in argv):
        return None
    by_path = argv[:2] == ("ros2", "launch") and argv[2:3] and argv[2] in tree.alone
    if len(argv) < _WORDS.get(argv[0], 1) + is_component(argv) - bool(by_path):
        return None  # a sentence about the command
    if argv[0] in _WORDS or argv[0] in SIMULATORS:
        return _of_ros(argv, mention, tree) if ros else None
    if not argv[0].startswith("python"):
        installed = argv if argv[0] in tree.installed and not ros else None
        return (_built(argv, tree) if ros or compiled else None) or installed or script_of(argv, mention, ros, compiled)
    named = (file for file in mention.files if file.endswith(".py") or bare(file))  # a script needs no guard to be run
    programs = tuple(dict.fromkeys((*tree.programs, *named)))
    if argv[1:2] == ("-m",):
        here = _module(argv, programs, (*tree.projects, *filter(None, (mention.inside,))))
    else:
        here = _here(argv, programs, mention.file.rpartition("/")[0])
    if here is None or (compiled and _tests(here)):
        return None
    return ("python3" if ros else argv[0], *here)


def _of_ros(argv: tuple[str, ...], mention: Mention, tree: _Tree) -> tuple[str, ...] | None:
    """Return a command of the repository's ROS version; ``None`` if its launch file is not in the tree.

    ``roslaunch path/to/a.launch`` becomes ``roslaunch PACKAGE a.launch``, where the package has one of that name.
    """
    if argv[0] in SIMULATORS:
        return argv if argv[0] in tree.simulators and not {*mention.files}.isdisjoint(argv) else None
    if (argv[0] == "ros2") != (tree.kind == "ros2"):
        return None
    start = argv[:1] if argv[0] == "roslaunch" else argv[:2] if argv[1:2] == ("launch",) else ()
    if not start:
        return argv
    package, *rest = argv[len(start) :]
    if LAUNCH.search(package):
        call = call_of(package, tree.calls, tree.alone)
        return (*start, *call, *rest) if call else None
    if package not in tree.packages:
        return argv
    file = next((word.rpartition("/")[2] for word in rest if not word.startswith("-")), "")
    return argv if file in tree.launched.get(package, ()) else None


def _built(argv: tuple[str, ...], tree: _Tree) -> tuple[str, ...] | None:
    """Return the call of a compiled program by its name: ``./build/align a`` becomes ``align a``.

    ``ros2 run`` looks in ``lib/PACKAGE`` alone; what is installed into ``bin`` is on the PATH of a sourced workspace
    (ros2/ros2cli: ros2pkg/ros2pkg/api/__init__.py; ament/ament_package: environment_hook/path.sh.in; 2026-11-23).
    """
    name = argv[0].rpartition("/")[2]
    if name in tree.made and argv[0].startswith("./"):  # it lies where make was called, or below
        return (f"./{posixpath.normpath(posixpath.join(tree.made[name], argv[0]))}", *argv[1:])
    if name not in tree.compiled:
        return None
    if tree.kind == "cpp" and _BESIDE.fullmatch(argv[0]):  # the page is in its build folder, the image at the root
        argv = (argv[0], *(_ABOVE.sub(r"\1", word) for word in argv[1:]))
    if not (package := tree.compiled[name]) or argv[0].endswith(f"install/{package}/bin/{name}"):
        return (name, *argv[1:])
    return ("rosrun", package, name, *argv[1:]) if tree.kind == "ros1" else ("ros2", "run", package, name, *argv[1:])


def _tests(argv: tuple[str, ...]) -> bool:
    """Tell whether a command only runs tests or benchmarks."""
    programs = [part for part in argv if part.endswith(".py")]
    return any(part.endswith("_test.py") or places.test(part) for part in programs)


def _module(argv: tuple[str, ...], programs: tuple[str, ...], above: tuple[str, ...]) -> tuple[str, ...] | None:
    """Return the arguments of ``python -m`` if the module is at the root, or the one of that name below a folder.

    ``above``: the folders that pip installs, whose packages any folder may import, and the one that the page goes to.
    """
    module = argv[2].replace(".", "/") if len(argv) > 2 else ""
    files = (f"{module}.py", f"{module}/__main__.py")
    if not {*files} & {*programs}:
        below = [program for program in programs if program.endswith(tuple(f"/{file}" for file in files))]
        if len(below) != 1 or not any(not folder or below[0].startswith(f"{folder}/") for folder in above):
            return None
    return argv[1:]


def _here(argv: tuple[str, ...], programs: tuple[str, ...], folder: str) -> tuple[str, ...] | None:
    """Return the arguments of a Python that runs a program of the tree, its path from the root; else ``None``.

    ``folder``: that of the page, whose own program is meant where others have the same name.
    """
    for position, part in enumerate(argv[1:], 1):
        if part.endswith(".py") or (bare(part) and part in programs):
            path = posixpath.normpath(part)
            beside = [near for near in (path, f"{folder}/{path}") if near in programs]
            ends = beside[:1] or [program for program in programs if program.endswith("/" + path)]
            return (*argv[1:position], ends[0], *argv[position + 1 :]) if len(ends) == 1 else None
    return None
