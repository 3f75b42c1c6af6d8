"""The commands that the pages of a repository run, as they can be run from its root."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping

from roslab.config.model import Kind
from roslab.decide.absent import absent, brought_files
from roslab.decide.blank_launches import LAUNCH, pointed_launches, with_a_launch_file, with_the_one_named
from roslab.decide.candidate import Candidate, demanded, inside_of, is_component, program_of
from roslab.decide.filled_in import PLACEHOLDER, filled
from roslab.decide.launch_calls import (
    as_found,
    call_of,
    found_by_path,
    from_root,
    is_path,
    launch_calls,
    names_of_launch_files,
    of_own_package,
    without_package,
)
from roslab.decide.made_folders import made_before
from roslab.decide.own_test_runs import runs_tests
from roslab.decide.pages_of_tools import of_a_tool, outside, starting_packages
from roslab.decide.programs import by_source, in_packages, installed_by_pip, on_path, one_letter_off, one_of_several
from roslab.decide.reasons import of_readme
from roslab.decide.renamed_launches import Declared, declared_by, renamed
from roslab.decide.ros.installed_programs import with_installed
from roslab.decide.ros.workspace import packages_of
from roslab.decide.run_by_page import why_run
from roslab.decide.scripts import bare, script_of, task_of
from roslab.decide.sections import about_trouble
from roslab.decide.simulators import simulators_of
from roslab.decide.without_others import clones_others, without_others
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose import copies
from roslab.evidence.prose.install_tree import package_and_program
from roslab.evidence.prose.runners import SIMULATORS
from roslab.evidence.roles import CONTAINER
from roslab.knowledge.released import converting_packages, ever_released
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern
from roslab.values.words import written as as_written

_WORDS = {"ros2": 4, "roslaunch": 2, "rosrun": 3}  # the fewest of a command that starts something
_BESIDE = pattern(r"\./[\w.+-]+")
_ABOVE = pattern(r"^(--?[\w-]+=)?(?:\.\./)+(?=[\w-])")
_NO_NODES = ("python", "bash", "jupyter")
"""What starts a program that may be no node: of a shell script nobody knows."""
_USAGE = pattern(r"\[-(?:h|-help)\b")
"""What argparse prints of a program, which is no call of it."""
_MANY = 10
"""Packages of a collection: what the page of one of them runs by its path is a tool of that one."""
TOOLS = frozenset({"setup.py", "setup_db.py", "conftest.py", "get-pip.py", "download.py", "manage.py"})
"""Files that serve a project without being its purpose."""


def written(evidence: Evidence, kind: Kind, *, ros: bool, compiled: bool) -> tuple[Candidate, ...]:
    """Return what READMEs run; a subfolder's page, examples and helper scripts of compiled code are weaker.

    So is a file of Python that no package has, beside nodes or on a page below the root of a repository of ROS, and any
    that the page of one package runs in a collection of packages; and, where packages have launch files, what the
    page of a folder without any runs. Not one that starts something of the packages itself, from the page at the root.
    """
    found = tuple(with_installed(calls_of(evidence, kind, ros=ros, compiled=compiled), evidence))
    nodes = ros and any(each.strong and not each.argv[0].startswith(_NO_NODES) for each in found)
    folders = tuple(f"{m.file.rpartition('/')[0]}/" for m in packages_of(evidence).built if "/" in m.file)
    many = ros and len(folders) >= _MANY
    starting = starting_packages(evidence, packages_of(evidence).names) if nodes else frozenset()
    lone = [outside(c, folders, starting, many=many) for c in found]
    tools = [ros and of_a_tool(c, folders, evidence) for c in found]
    weak = [(nodes or (ros and "/" in c.file)) and apart for c, apart in zip(found, lone, strict=True)]
    weak = [apart or tool for apart, tool in zip(weak, tools, strict=True)]
    said = (replace(c, strong=False) if apart else c for c, apart in zip(found, weak, strict=True))
    return without_others(said, evidence) if ros else tuple(said)


def calls_of(evidence: Evidence, kind: Kind, *, ros: bool, compiled: bool) -> Iterator[Candidate]:
    """Yield each call of the pages that starts something of the tree, as it is from the root."""
    tree = _Tree(
        kind=kind,
        programs=tuple(script.file for script in evidence.programs),
        nodes=frozenset(script.file for script in evidence.programs if script.kind == "node" and not ros),
        compiled=in_packages(evidence, kind) if ros else dict.fromkeys(on_path(evidence), ""),
        launched=names_of_launch_files(evidence),
        calls=launch_calls(evidence),
        by_path=found_by_path(evidence),
        alone=frozenset(each.file for each in evidence.launch if not each.package),
        declared=declared_by(evidence),
        simulators=simulators_of(evidence),
        packages=packages_of(evidence).names,
        clones=clones_others(evidence),
        installed=installed_by_pip(evidence),
        projects=(
            *(project.folder for project in evidence.python if project.installable),
            *(m.value for m in evidence.mentions if m.topic == "python_path" and m.value != "."),
        ),
        made={name: each.folder for each in evidence.makefiles if compiled for name in each.programs},
        tasks={name: command for environment in evidence.conda for name, command, _ in environment.tasks},
    )
    said = [m for m in evidence.mentions if m.topic == "command" and m.source == "readme"]
    said = [m for m in said if not (places.vendored(m.file) or about_trouble(m.heading))]
    said.sort(key=lambda m: not of_readme(m.file))
    of_python = {m.value for m in evidence.mentions if m.topic == "runs"} if not (ros or compiled) else set()
    elsewhere = {m.value for m in evidence.mentions if m.topic == "elsewhere"}
    tried, withheld, named = (
        {(m.file, m.line, m.value) for m in evidence.mentions if m.topic == topic}
        for topic in ("tried", "withheld", "said_run")
    )
    made = [m for m in evidence.mentions if m.topic == "made" and m.source == "readme"]
    options = {(m.file, m.value): m.text for m in evidence.mentions if m.topic == "option"}
    fetched = brought_files(evidence)
    fetching = {m.inside for m in evidence.mentions if m.topic == "fetched" and m.inside}
    pointed = pointed_launches(evidence)
    beside = tree.compiled if compiled and not ros else {}  # programs that a page starts in its build folder
    nearest = min((m.file.count("/") for m in said if not m.heading.endswith(CONTAINER)), default=0)
    for mention in said:
        whole, gap, blanks = filled(from_root(mention.value, (*tree.calls, *tree.alone)), mention.files)
        whole = with_the_one_named(whole, mention, pointed)
        program = next((file for file in mention.files if file.endswith(".py")), "")
        told = {options.get((program, name), "") for name in gap}
        argv = _runnable(whole, mention, tree, ros=ros, compiled=compiled)
        if argv is not None and not fetching & {*argv[:2]} and not (gap and _USAGE.search(mention.value)):
            strong = not compiled or not any(places.example(part) for part in program_of(argv))
            place = (mention.file, mention.line, mention.value)
            once = place in tried
            strong = strong and (once or not (compiled and argv[0].startswith("python")))
            strong = strong and (ros or mention.file.count("/") == nearest) and (place in named or not runs_tests(argv))
            strong = strong and place not in withheld
            strong = strong and not copies.below(mention.file, evidence.copies)
            yield Candidate(
                argv=tuple(map(as_written, argv)),
                why=why_run(argv, mention, kind),
                file=mention.file,
                line=mention.line,
                strong=strong,
                heading=mention.heading,
                files=mention.files,
                inside=inside_of(argv, mention.inside, beside, tree.made),
                cut=bool(gap) and told != {"default"},
                demands=demanded(told, mention.value),
                absent=absent(argv, mention.files, fetched),
                blanks=blanks,
                variables=mention.variables,
                installed=argv[0] in tree.installed and not ros,
                elsewhere=argv[0].startswith(("bash", "python")) and not elsewhere.isdisjoint(argv[1:2]),
                tried=once,
                makes=made_before(mention, made) if argv[0] not in {*_WORDS, "jupyter", "streamlit"} else (),
                of_python=argv[0] == "bash" and not of_python.isdisjoint(argv[1:2]),
            )


@dataclass(frozen=True, kw_only=True, slots=True)
class _Tree:
    """What the tree has to start."""

    kind: Kind
    programs: tuple[str, ...]
    nodes: frozenset[str]
    """Those of them that are nodes of ROS, which the image does not have."""
    compiled: Mapping[str, str]
    """Compiled programs, each with its package, ``""`` where there is none."""
    launched: Mapping[str, frozenset[str]]
    """The launch files of each package, by their names."""
    calls: Mapping[str, tuple[str, ...]]
    """How each launch file of the tree is started, by its path."""
    by_path: Mapping[tuple[str, str], str]
    """Those that their packages do not install, by package and name."""
    alone: frozenset[str]
    """Launch files that belong to no package."""
    declared: Declared
    simulators: frozenset[str]
    packages: frozenset[str]
    clones: bool
    """Other repositories are cloned, whose packages are not known."""
    installed: frozenset[str]
    """Programs that pip installs with the repository."""
    projects: tuple[str, ...]
    """Folders that pip installs, or a page puts on PYTHONPATH."""
    tasks: Mapping[str, str]  # pixi's, by their names
    made: Mapping[str, str]
    """Programs that a Makefile may compile, each with its folder."""


def _runnable(
    words: tuple[str, ...], mention: Mention, tree: _Tree, *, ros: bool, compiled: bool
) -> tuple[str, ...] | None:
    """Return the argv of a command as it can be run from the root; ``None`` if it starts nothing from the tree."""
    argv = with_a_launch_file(task_of(words, tree.tasks), tree.launched)
    if not argv or any(map(PLACEHOLDER.search, program_of(argv))) or any(p.rpartition("/")[2] in TOOLS for p in argv):
        return None
    direct = argv[:2] == ("ros2", "launch") and argv[2:3] and is_path(argv[2], tree.calls, tree.alone, mention.file)
    if len(argv) < _WORDS.get(argv[0], 1) + is_component(argv) - bool(direct):
        return None  # a sentence about the command
    if argv[0] in _WORDS or argv[0] in SIMULATORS:
        return _of_ros(argv, mention, tree) if ros else None
    if not argv[0].startswith("python"):
        installed = argv if (argv[0] in tree.installed and not ros) or argv[0] == "make" else None
        return (_built(argv, tree) if ros or compiled else None) or installed or script_of(argv, mention, ros, compiled)
    from roslab.decide.python_calls import module_of, program_here  # noqa: PLC0415 - not for ROS

    named = (file for file in mention.files if file.endswith(".py") or bare(file))  # a script needs no guard to be run
    programs = tuple(dict.fromkeys((*tree.programs, *named)))
    if argv[1:2] == ("-m",):
        here = module_of(argv, programs, mention, tree.projects, by_path=not (ros or compiled))
    else:
        here = program_here(argv, programs, mention.file.rpartition("/")[0])
    if here is None or (compiled and runs_tests(here)) or not tree.nodes.isdisjoint(here[:1]):
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
        return _program_of_ros(argv, tree)
    package, *rest = words = of_own_package(argv[len(start) :], tree.launched)
    argv = (*start, *words)
    if LAUNCH.search(package) or without_package(package, tree.alone, mention.file):
        call = call_of(package, tree.calls, tree.alone, mention.file)
        return (*start, *call, *rest) if call else None
    if package not in tree.packages:
        there = _somewhere(package, tree)
        other = () if there or "/" in mention.file else renamed(words, tree.declared)
        return argv if there else (*start, *other) if other else None
    file = next((word.rpartition("/")[2] for word in rest if not word.startswith("-")), "")
    return (*start, *as_found(words, tree.by_path)) if file in tree.launched.get(package, ()) else None


def _program_of_ros(argv: tuple[str, ...], tree: _Tree) -> tuple[str, ...] | None:
    """Return ``rosrun`` or ``ros2 run`` of a package that has the program; ``None`` where nothing has the package.

    A page may name the wrong one of the tree's packages, or the source of a program, of the one that compiles it.
    """
    words = argv[1 if argv[0] == "rosrun" else 2 :]
    if len(words) < 2 or (argv[0] == "ros2" and argv[1] != "run"):
        return argv
    package, program, *rest = words
    if package not in tree.packages:
        return argv if _somewhere(package, tree) else None
    other = "" if _has(package, program, tree) else tree.compiled.get(program := by_source(program, tree.compiled), "")
    return _run(other, program, tuple(rest), tree) if other else argv


def _somewhere(package: str, tree: _Tree) -> bool:
    """Tell whether a package that the tree does not have may be there: released, or in a repository that is cloned."""
    return package not in converting_packages() and (tree.clones or ever_released(package))


def _built(argv: tuple[str, ...], tree: _Tree) -> tuple[str, ...] | None:
    """Return the call of a compiled program by its name: ``./build/align a`` becomes ``align a``.

    ``ros2 run`` looks in ``lib/PACKAGE`` alone; what is installed into ``bin`` is on the PATH of a sourced workspace
    (ros2/ros2cli: ros2pkg/ros2pkg/api/__init__.py; ament/ament_package: environment_hook/path.sh.in; 2026-11-23).
    """
    if lies := package_and_program(argv[0]):
        if tree.kind != "cpp":
            return _run(*lies, argv[1:], tree) if _has(*lies, tree) else None
        argv = (f"./{argv[0]}", *argv[1:])
    name = argv[0].rpartition("/")[2]
    if name in tree.made and argv[0].startswith("./"):  # it lies where make was called, or below
        folder = "" if argv[0].startswith(f"./{tree.made[name]}/") else tree.made[name]
        return (f"./{posixpath.normpath(posixpath.join(folder, argv[0]))}", *argv[1:])
    if name not in tree.compiled and tree.kind == "cpp" and "/" in argv[0] and argv[0] not in tree.programs:
        name = one_letter_off(name, tree.compiled) or one_of_several(name, tree.compiled) or name
        argv = (posixpath.join(posixpath.dirname(argv[0]), name), *argv[1:])
    if name not in tree.compiled:
        return None
    if tree.kind == "cpp" and _BESIDE.fullmatch(argv[0]):  # the page is in its build folder, the image at the root
        argv = (argv[0], *(_ABOVE.sub(r"\1", word) for word in argv[1:]))
    if not (package := tree.compiled[name]) or argv[0].endswith(f"install/{package}/bin/{name}"):
        return (name, *argv[1:])
    return _run(package, name, argv[1:], tree)


def _has(package: str, program: str, tree: _Tree) -> bool:
    """Tell whether a package of the tree has a program: one that it compiles, or a script, which may have no ending."""
    compiled = {name for name, of in tree.compiled.items() if of == package}
    scripts = {path.rpartition("/")[2] for path in tree.programs}
    there = program in compiled or {program, f"{program}.py"} & scripts or not compiled
    return package in tree.packages and bool(there)


def _run(package: str, program: str, rest: tuple[str, ...], tree: _Tree) -> tuple[str, ...]:
    """Return the call of a package's program."""
    return (*(("rosrun",) if tree.kind == "ros1" else ("ros2", "run")), package, program, *rest)
