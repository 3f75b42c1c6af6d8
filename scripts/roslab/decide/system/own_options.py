"""The options and the compiler with which CMake configures the repository itself: those of the page at its root."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.config.model import BuildTool, Config, Source
from roslab.decide.ros.part_builds import ONLY, builds, by_script, configured, to_whole
from roslab.decide.ros.source_names import plain
from roslab.decide.stopped_cmake import options_that_lack
from roslab.decide.system.switches import given
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern
from roslab.values.words import line_of

_OWN = pattern(r"-D(?!CMAKE_)[A-Za-z_]\w*?(?<!_DIR)(?<!_ROOT)(?<!_PATH)(?<!_PREFIX)(?::[A-Z]+)?=[\w.+-]+")
"""An option of the project's own; CMake's are about the author's machine, and paths too."""


_COMPILER = pattern(r"-DCMAKE_(C|CXX)_COMPILER(?::[A-Z]+)?=(?:/usr/bin/)?((?:gcc|g\+\+|clang|clang\+\+)-\d+(?:\.\d+)?)")
_VARIABLES = {"C": "CC", "CXX": "CXX"}
_UNDECLARED = pattern(r"(?:[A-Z0-9]+_)??(?:BUILD|COMPILE|ENABLE|MAKE|USE|WITH)_(?!TEST)\w+")
"""What an option is called that no ``option`` declares: unset, it is off."""


_MAKEFILES = frozenset({"GNUmakefile", "makefile", "Makefile"})
_BUILDS = pattern(r"(?:build|compile|make)(?:[-_](?:all|linux|project|release))?\.(?:sh|bash)")
"""A script at the root that builds the project."""
_OF_ROS: frozenset[BuildTool] = frozenset({"catkin_make", "catkin_make_isolated", "catkin_tools", "colcon"})
_GPU = pattern(r"-D\w*(?:CUDA|GPU|TENSORRT|TRT)\w*(?::[A-Z]+)?=(?!OFF|0|FALSE|NO)", re.IGNORECASE)
"""An option that a page has for machines with a GPU."""


def own_options(evidence: Evidence, config: Config, folder_name: str, build_tool: BuildTool) -> tuple[str, ...]:
    """Return the options of the first ``cmake`` that a page at the root runs for the repository, not for a library.

    Where that has none, those of the Makefile there, or of a script that builds.

    ``folder_name`` is the repository's name, into whose folder the page may go. Of a workspace of ROS, what the first
    call of its build tool on such a page, else in the one script at the root that has any, gives CMake, and what
    catkin_tools was told to keep before it; where that builds a part of it, also what the calls behind it give until
    the whole is built. Before them come variables that CMake files use and nothing sets.
    """
    meant = () if config.compatible else tuple(f"-D{name}={value}" for name, value in evidence.misnamed)
    meant += () if config.compatible else tuple(_handed(evidence))
    if build_tool in _OF_ROS:
        return (*meant, *_of_workspace(evidence, config, build_tool))
    if build_tool != "cmake":
        return ()
    said = [word for word in _said(evidence, config, folder_name) if word.startswith("-D")]
    own = tuple(word for word in said if _OWN.fullmatch(word)) if said else _by_author(evidence, config)
    return (*meant, *own, *_of_programs(evidence, config, own), *_without_code(evidence, config, own))


def _handed(evidence: Evidence) -> Iterator[str]:
    """Yield the options that get the folder of an archive which the image unpacks in its user's home: ``-DX=~/sdk``."""
    yield from (f"-D{mention.value}" for mention in evidence.mentions if mention.topic == "handed_place")


def where_built(options: Iterable[str], built: Iterable[Source]) -> Iterator[str]:
    """Yield options that name a folder of headers of Ubuntu's, as those lie of a library that the image builds."""
    folders = {f"/usr/include/{source.name}" for source in built if source.tabled}
    for option in options:
        name, sign, folder = option.partition("=")
        yield f"{name}{sign}{folder.replace('/usr/', '/usr/local/', 1)}" if folder in folders else option


def _of_programs(evidence: Evidence, config: Config, own: tuple[str, ...]) -> tuple[str, ...]:
    """Return what turns on the options that programs need, as a page or CI says, where no page sets them otherwise."""
    said = {word.partition("=")[0].partition(":")[0] for word in own}
    asked = () if config.compatible else (m.value for m in evidence.mentions if m.topic == "asked_option")
    options = [f"-D{name}=ON" for name in dict.fromkeys(asked) if f"-D{name}" not in said]
    return tuple(option for option in options if _OWN.fullmatch(option) and not _GPU.match(option))


def _without_code(evidence: Evidence, config: Config, own: tuple[str, ...]) -> Iterator[str]:
    """Yield what turns off the options for which CMake compiles code that the tree does not have."""
    said = {word.partition("=")[0].partition(":")[0] for word in own}
    lacking = () if config.compatible else dict.fromkeys(option for _, option, _, _ in options_that_lack(evidence))
    yield from (f"-D{option}=OFF" for option in lacking if f"-D{option}" not in said)


def _of_workspace(evidence: Evidence, config: Config, build_tool: BuildTool) -> tuple[str, ...]:
    calls = () if config.compatible else builds(evidence, build_tool) or by_script(evidence, build_tool)
    kept = configured(evidence, build_tool) if calls else ()
    words = (word for call in (*kept, *to_whole(calls)) for word in call.text.replace(" -D ", " -D").split())
    words = (word.replace(":=", "=", 1) if word.startswith("-D") else word for word in words)  # ``-DGUI:=ON``: no type
    given = (word for word in words if _OWN.fullmatch(word) and not _GPU.match(word) and not ONLY.fullmatch(word))
    return tuple({word.partition("=")[0].partition(":")[0]: word for word in given}.values())


def options_of_program(
    evidence: Evidence, config: Config, build_tool: BuildTool, command: tuple[str, ...] | str, *, cuda: bool
) -> tuple[str, ...]:
    """Return what turns on the options that the program of the command waits for, and that nobody sets.

    Not one for a GPU in an image without CUDA.
    """
    program = posixpath.basename((line_of(command).split() or [""])[0])
    said = given(evidence)
    found = [project for project in evidence.cmake if program in dict(project.executables)]
    if build_tool != "cmake" or config.compatible or len(found) != 1:
        return ()
    waits = (variable for name, variable in found[0].optional if name == program)
    names = (each.removeprefix("OFF ") for each in waits if each.startswith("OFF ") or _UNDECLARED.fullmatch(each))
    free = (name for name in dict.fromkeys(names) if name not in found[0].settled)
    options = [f"-D{name}=ON" for name in free if f"-D{name}" not in said]
    return tuple(option for option in options if cuda or not _GPU.match(option))


def own_compilers(evidence: Evidence, config: Config, folder_name: str) -> tuple[tuple[str, str], ...]:
    """Return the compilers of a version that the same ``cmake`` names, each with its variable: ``CXX``, ``g++-10``."""
    found = (_COMPILER.fullmatch(word) for word in _said(evidence, config, folder_name))
    return tuple((_VARIABLES[match[1]], match[2]) for match in found if match)


def _said(evidence: Evidence, config: Config, folder_name: str) -> list[str]:
    names = {plain(folder_name), *(plain(p.name) for p in evidence.cmake if p.top_level and p.name)}
    for said in evidence.mentions:
        of_page = said.topic == "compiled" and said.source == "readme" and "/" not in said.file
        own = said.value == "." or plain(said.value.rpartition("/")[2]) in names
        if of_page and own and not config.compatible:
            return said.text.split()
    return []


def _by_author(evidence: Evidence, config: Config) -> tuple[str, ...]:
    """Return the options of the project's own that its Makefile at the root gives CMake, else its script that builds.

    A Makefile gives those of its own folders, too.
    """
    said = [m for m in evidence.mentions if m.topic == "compiled" and m.source == "script" and m.value == "."]
    if config.compatible or not said:
        return ()
    made = next((m.text.split() for m in said if m.file in _MAKEFILES), None)
    if made is not None:
        return tuple(made)
    built = next((m.text.split() for m in said if _BUILDS.fullmatch(m.file)), [])
    return tuple(word for word in built if _OWN.fullmatch(word))
