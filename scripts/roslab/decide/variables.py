"""Variables without which the build or a program stops: those of the author's pages, and one of CMake."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.config.cited import shown
from roslab.config.model import BuildTool, Config
from roslab.decide.candidate import Candidate
from roslab.decide.decision import Choice, Download, Warning_
from roslab.decide.launched_simulators import brought_simulators
from roslab.decide.launched_windows import opened_by_nodes
from roslab.decide.python.library_modules import variables_of
from roslab.decide.reasons import because, warn
from roslab.decide.ros.author_variables import author_variables
from roslab.decide.ros.linked_folders import linked_folders
from roslab.decide.ros.nested_headers import nested_headers
from roslab.decide.ros.robot_models import untold_models
from roslab.decide.system.cmake_version import KEPT_BY_NEW, POLICY, refused_by_new
from roslab.decide.system.cmeel import PREFIX
from roslab.decide.system.header_folders import compiler_variables
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.own_places import OPT, PYTHON
from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.machine_variables import of_every_image, of_one_machine
from roslab.knowledge.offscreen import offscreen, onscreen
from roslab.knowledge.search_paths import search_paths
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement

SET = 40
"""Weight of the reason; nothing competes with it."""
LONGEST_MESSAGE = 200
"""Characters of an error of the code that are cited."""
_SEARCHED = frozenset({"PATH", "PYTHONPATH"})
_HOME, _FOLDER = "CUDA_HOME", "/usr/local/cuda"
"""https://docs.nvidia.com/cuda/cuda-installation-guide-linux/, read 2026-11-26."""
_WITH_NVCC = pattern(r"(?:^|/)cuda(?:gl)?:[\w.-]*-devel\b")
_NVCC_OF_CONDA = frozenset({"cuda-nvcc", "cuda-compiler", "cuda-toolkit", "cuda", "cudatoolkit-dev"})
"""Packages of conda with a compiler of their own, which is found on PATH before the image's."""
_VALUE = pattern(r"(?!/|~|YOUR|your[_-]|path[/_-]to)[\w.+:,@=%/-]{1,100}")
"""A value that is written out and is no place on the author's machine."""


def decide_variables(
    evidence: Evidence,
    config: Config,
    ubuntu: str | None,
    asked: Iterable[Requirement],
    *,
    command: Candidate | None = None,
    argv: tuple[str, ...] | str = (),
    image: str = "",
    ros: str | None = None,
    gui: bool = True,
    dockerfile: str | None = None,
    apt: AbstractSet[str] = frozenset(),
    downloads: Iterable[Download] = (),
    libraries: Iterable[str] = (),
) -> Choice[tuple[tuple[str, str], ...]]:
    """Return each variable with the value that roslab.yaml gives it, else a page first.

    After them those that a page starts the default ``command`` with, without those of one machine, what its words
    ``argv`` stop without, and what keeps a new CMake from refusing old code; ``asked``: what pip installs or builds
    with. Where the base ``image`` has CUDA's compiler, the folder that it lies in: NVIDIA's images do not say it, and
    build files read it. Without ``gui``, what has packages draw where there is no display; with it, what they need to
    open a window. ``dockerfile``: the author's that the image is made with; ``apt``: what is installed;
    ``downloads``: what is fetched, some of it for the home; ``libraries``: those that are built.
    """
    if config.compatible:
        return Choice(answer=())
    asked = tuple(asked)
    given = dict(config.env)
    found: dict[str, tuple[str, Mention]] = {}
    for mention in _said(evidence, downloads):
        name, _, value = mention.value.partition("=")
        if name not in _SEARCHED or _installed(value, mention, evidence):
            value = value.replace(PYTHON, python_of_ubuntu().get(ubuntu or "", "3"))
            found.setdefault(name, (given.get(name, value), mention))
    pairs = {name: value for name, (value, _) in found.items()}
    reasons = [
        because("workspace", f"{name}={value}", _why(name, value, place), place, weight=SET)
        for name, (value, place) in found.items()
    ]
    before = _before(command, evidence) if command else ()
    for name, value in (each.split("=", 1) for each in before):
        if command and name not in pairs and not of_one_machine(name) and _VALUE.fullmatch(value):
            pairs[name] = given.get(name, value)
            why = "a page starts the default command with it"
            reasons.append(because("workspace", f"{name}={pairs[name]}", why, command, weight=SET))
    if _HOME not in {*pairs, *given} and _WITH_NVCC.search(image) and not _NVCC_OF_CONDA & _conda(evidence):
        pairs[_HOME] = _FOLDER
        why = f"{image} has CUDA's compiler there, and does not say it"
        reasons.append(because("workspace", f"{_HOME}={_FOLDER}", why, weight=SET))
    if POLICY not in {*pairs, *given} and (old := refused_by_new(evidence, ubuntu, asked)):
        pairs[POLICY] = str(KEPT_BY_NEW)
        why = f"CMake 4 may be in the image, and refuses code for {old.version}"
        reasons.append(because("workspace", f"{POLICY}={KEPT_BY_NEW}", why, old, weight=SET))
    windows = _windows(command, evidence)
    authors = tuple(author_variables(evidence, ros, dockerfile, apt))
    untold = () if dockerfile else untold_models(evidence, argv, {*pairs, *given, *(name for name, *_ in authors)})
    further: list[tuple[str, str, str, Requirement | Dependency | Mention | None]] = [
        *authors,
        *compiler_variables(evidence, ubuntu),
        *nested_headers(evidence, ros),
        *linked_folders(evidence, ros),
        *(each.set for each in untold),
        *((name, value, why, None) for name, value, why in variables_of(libraries)),
        *(
            (
                each.variables[-1],
                each.folder,
                f"the default command starts {each.program}, which is installed there",
                used,
            )
            for used, each in brought_simulators(evidence, config, command.argv if command else (), ros)
        ),
    ]
    for name, value, why, asks in (*(_drawing(asked, windows) if gui else _offscreen(asked)), *further):
        if name not in {*pairs, *given}:
            pairs[name] = value
            reasons.append(because("workspace", f"{name}={value}", why, asks, weight=SET))
    demanded = [m for m in evidence.mentions if m.topic == "demanded" and m.value not in {*pairs, *given}]
    demanded = [m for m in demanded if not (of_every_image(m.value) or m.value.startswith("-D"))]
    lacking = () if dockerfile or (evidence.python and not ros) else _options_lacking(evidence, config)
    warnings = (*map(_demanded, demanded), *lacking, *(each.warning for each in untold if each.warning))
    return Choice(answer=tuple(pairs.items()), reasons=tuple(reasons), warnings=warnings)


def _said(evidence: Evidence, downloads: Iterable[Download]) -> Iterator[Mention]:
    """Yield the variables of pages, those with a place in the home only where something is unpacked there."""
    there = tuple(f"~/{each.unpack}".removesuffix(".") for each in downloads if each.home)
    for mention in evidence.mentions:
        value = mention.value.partition("=")[2]
        if mention.topic == "variable" and (not value.startswith("~/") or value.startswith(there)):
            yield mention


def _demanded(mention: Mention) -> Warning_:
    what = "CMake" if mention.file.endswith("CMakeLists.txt") else "a program"
    message = f"{what} stops without the variable {mention.value} (it says: {_message(mention)})"
    return warn(f"{message}: set it under `env` in roslab.yaml", mention)


def _message(mention: Mention) -> str:
    """Return an error of the code on one line, as far as it tells what is lacking."""
    return shown(" ".join(mention.text.replace("\\n", " ").split()), LONGEST_MESSAGE)


def _options_lacking(evidence: Evidence, config: Config) -> Iterator[Warning_]:
    """Yield a warning for each option without which CMake stops, and that no page gives it in a form that is taken."""
    demanded = {m.value: m for m in evidence.mentions if m.topic == "demanded" and m.value.startswith("-D")}
    if not demanded:
        return
    from roslab.decide.system.own_options import own_options  # noqa: PLC0415 - few trees demand any

    tools: tuple[BuildTool, ...] = ("cmake", "colcon", "catkin_make", "catkin_make_isolated", "catkin_tools")
    taken = " ".join(word for tool in tools for word in own_options(evidence, config, "", tool))
    said = f" {taken} {config.cmake_options} {' '.join(config.build_args)}"
    for option, mention in demanded.items():
        if not any(f"{option}{sign}" in said for sign in "=:"):
            message = f"CMake stops without {option} (it says: {_message(mention)})"
            yield warn(f"{message}: give it in `cmake_options` in roslab.yaml", mention)


def _offscreen(asked: Iterable[Requirement]) -> Iterator[tuple[str, str, str, Requirement]]:
    for each in asked:
        if each.key in offscreen():
            why = f"{each.key} draws without a display then, and the image has none"
            yield (*offscreen()[each.key], why, each)


def _drawing(asked: Iterable[Requirement], windows: frozenset[str]) -> Iterator[tuple[str, str, str, Requirement]]:
    for each in asked if windows else ():
        by, name, value = onscreen().get(each.key, (frozenset(), "", ""))
        if by & windows:
            yield name, value, f"{each.key} stops without it where it opens a window", each


def _windows(command: Candidate | None, evidence: Evidence) -> frozenset[str]:
    """Return the libraries by which the file of a command opens windows."""
    argv = command.argv if command else ("",)
    by_file = (each for each in evidence.code if each.namespace == "call" and each.file in argv)
    return frozenset(each.name for each in (*by_file, *opened_by_nodes(evidence, argv)))


def _conda(evidence: Evidence) -> set[str]:
    return {package.name for environment in evidence.conda for package in environment.packages}


def _before(command: Candidate, evidence: Evidence) -> tuple[str, ...]:
    """Return what a page sets before it starts a command: on its line, else above it in its section."""
    above = (
        mention.value
        for mention in evidence.mentions
        if mention.topic == "exported"
        and (mention.file, mention.heading) == (command.file, command.heading)
        and (mention.line or 0) < command.line
    )
    return (*command.variables, *above)


def _installed(value: str, mention: Mention, evidence: Evidence) -> bool:
    """Tell whether the page of a path in ``/opt`` installs the package whose folder that is: ``drake-dev``."""
    folder = value.removeprefix(OPT).partition("/")[0].lower()
    said = (each for each in evidence.prose if each.namespace == "apt" and each.file == mention.file)
    return any(each.name.removeprefix("lib").partition("-")[0] == folder for each in said)


def _why(name: str, value: str, place: Mention) -> str:
    if PREFIX in value:
        return f"{place.text} is in wheels of pip, whose libraries and packages of CMake lie there"
    if place.source == "code" and place.inside:
        return f"the tree names its own {place.text} below it"
    if place.file.endswith("CMakeLists.txt"):
        return "CMake stops without it"
    who = "a script of the tree" if place.source == "script" else "a page"
    return "the program stops without it" if place.source == "code" else f"{who} sets it{_reader(name, value)}"


def _reader(name: str, value: str) -> str:
    """Return what reads a variable, in words, nothing where that was not looked for."""
    from roslab.knowledge.build_variables import build_variables  # noqa: PLC0415 - few variables are asked for

    if name in build_variables():
        return f", and the build of {build_variables()[name]} reads it"
    if name in search_paths():
        return ", and the simulator reads it"
    return "" if value.startswith(("./", OPT)) else ", and the tree reads it"
