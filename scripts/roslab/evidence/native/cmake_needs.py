"""What one call of a CMakeLists.txt looks for: packages, pkg-config modules, link names, things to fetch."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from typing import Literal

from roslab.evidence import places
from roslab.evidence.dependency import Dependency, GitSource, Strength
from roslab.evidence.lex.cmake import Call
from roslab.knowledge.libraries import library
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern

_OF_GAZEBO = frozenset(["gz_find_package", "ign_find_package"])
_LIBRARIES_OF_GAZEBO = ("gz-", "ignition-")
"""Of what these find, its own libraries: https://github.com/gazebosim/gz-cmake, cmake/GzFindPackage.cmake, 2026-11-28;
of others they write names of files ``Find….cmake`` that gz-cmake brings."""
_FINDING = _OF_GAZEBO | {"find_package", "find_dependency", "add_project_dependency", "add_project_private_dependency"}
"""``find_package`` and what calls it: https://github.com/jrl-umi3218/jrl-cmakemodules, its package-config.cmake"""
CALLS = _FINDING | frozenset(
    [
        "pkg_check_modules",
        "pkg_search_module",
        "target_link_libraries",
        "swig_link_libraries",  # https://cmake.org/cmake/help/latest/module/UseSWIG.html, read 2026-11-29
        "link_libraries",
        "find_library",
    ]
)
FETCHING = frozenset({"fetchcontent_declare", "externalproject_add"})
BRINGING = FETCHING | {"cpmaddpackage", "cpmfindpackage", "download_project"}
"""https://github.com/cpm-cmake/CPM.cmake, its README.md, read 2026-11-26, and
https://github.com/Crascit/DownloadProject, its README.md, read 2026-11-27."""
_OF_ADDRESS = pattern(r"[:/@#\s]|\.git\b")
_FLAGS = frozenset(
    [
        "REQUIRED",
        "QUIET",
        "EXACT",
        "CONFIG",
        "MODULE",
        "NO_MODULE",
        "NO_POLICY_SCOPE",
        "GLOBAL",
        "NO_DEFAULT_PATH",
        "NO_CMAKE_PATH",
        "BYPASS_PROVIDER",
    ]
)
_VALUED = frozenset({"NAMES", "CONFIGS", "HINTS", "PATHS", "PATH_SUFFIXES", "REGISTRY_VIEW"})
_MODULE_FLAGS = frozenset(
    ["REQUIRED", "QUIET", "IMPORTED_TARGET", "GLOBAL", "NO_CMAKE_PATH", "NO_CMAKE_ENVIRONMENT_PATH"]
)
_LINK_WORDS = frozenset(
    [
        "PUBLIC",
        "PRIVATE",
        "INTERFACE",
        "LINK_PUBLIC",
        "LINK_PRIVATE",
        "LINK_INTERFACE_LIBRARIES",
        "debug",
        "optimized",
        "general",
    ]
)
_CATKIN = frozenset({"catkin", "catkin_simple"})
"""Packages of ROS whose components are packages themselves."""
_ROS_FINDERS = _CATKIN | {
    "ament_cmake",
    "ament_cmake_auto",
    "ament_cmake_ros",
    "ament_cmake_python",
    "rosidl_default_generators",
}
"""What ament made looks at no components: authors who come from catkin write some, of whatever name.

https://github.com/ament/ament_cmake (ament_cmake_core/cmake/core/templates/nameConfig.cmake.in), 2026-11-29
"""
_TEST = pattern(r"CATKIN_ENABLE_TESTING|BUILD_TEST(?:S|ING)?|_TESTS?\b|GTEST", re.IGNORECASE)
_OTHER = r"(?:WIN32|MSVC|APPLE|ANDROID|IOS|MINGW|CYGWIN|EMSCRIPTEN)"
_SYSTEM = r"(?:\$\{)?CMAKE_SYSTEM_NAME\}? (?:STREQUAL|MATCHES)"
_ELSEWHERE = pattern(rf"^(?:{_OTHER}\b|{_SYSTEM} (?!Linux))")
_HERE = pattern(
    rf"^(?:ON \w|NOT \(NEVER [\w ]+\)$|LINUX$|UNIX\b(?! AND (?:{_OTHER}))|"
    rf"NOT \(?{_OTHER}(?: (?:OR|AND) {_OTHER}){{0,6}}\)?$|NOT {_OTHER}\b|"
    rf"{_SYSTEM} Linux$|NOT \({_SYSTEM} (?:Windows|Darwin|Android|iOS|Emscripten)\)$)"
)
_SWITCH = pattern(r"^(?:ON|OFF) \w+$")
_NAME = pattern(r"^[A-Za-z][\w.+-]*$")
_LINK = pattern(r"^(?:-l)?([A-Za-z_][\w.+-]*)$")
_LOCAL = pattern(r"^/usr/local/lib/(?:[\w+-]+/)?lib([A-Za-z][\w+-]*)\.(?:so|a)$")
_INSIDE = pattern(
    r"^\$\{(?:PROJECT|CMAKE(?:_CURRENT)?)_SOURCE_DIR\}/(?:\.\./){0,5}([\w.+/-]{1,150}/lib[\w+-]{1,60}\.(?:so|a))$"
)
_VERSION = pattern(r"^\d+(?:\.\d+)*$")
_MODULE = pattern(r"^([A-Za-z][\w.+-]*?)(?:(?:>=|<=|=|>|<)[\d.]+)?$")
_LISTS = "/CMakeLists.txt"
MAX_LINKED = 60
COMPONENT = "component"
"""Role of a library that catkin is to find: it looks for configuration files alone, whatever the tree has beside."""


@dataclass(frozen=True, kw_only=True, slots=True)
class _Finder:
    """The words of a ``find_package`` after the name."""

    components: tuple[str, ...]
    optional: tuple[str, ...]
    version: str | None


def needs(call: Call, path: str, project: str | None) -> Iterator[Dependency]:
    """Yield what a call asks for; ``project`` is the name of the project itself."""
    words = call.words
    if call.name in _FINDING:
        yield from _found(call, path, project)
    elif call.name in {"pkg_check_modules", "pkg_search_module"}:
        strength = _strength(call, required="REQUIRED" in words)
        for word in words[1:]:
            if word not in _MODULE_FLAGS and (match := _MODULE.match(word)):
                yield _dependency("pkg-config", match[1], strength, call, path)
    else:
        vague = bool(call.conditions) or call.name == "find_library"
        for word in words[0 if call.name == "link_libraries" else 1 :][:MAX_LINKED]:
            if word not in _LINK_WORDS and (match := _LINK.match(word)):
                yield _dependency("link", match[1], "optional" if vague else "used", call, path)
        yield from files(call, path)


def of_lua(asked: Dependency, text: str) -> Dependency:
    """Return what a file of CMake asks for: Lua's Torch has the name of PyTorch's library, and sets folders for Lua.

    https://github.com/torch/torch7/blob/master/cmake/TorchConfig.cmake.in, read 2026-11-26.
    """
    return replace(asked, name="Torch7") if asked.name == "Torch" and "Torch_INSTALL_LUA" in text else asked


def files(call: Call, path: str) -> Iterator[Dependency]:
    """Yield the libraries that a call names by their files below /usr/local: only what is built by hand lies there."""
    for word in call.words[:MAX_LINKED]:
        if word.startswith("/") and (match := _LOCAL.match(word)):
            yield _dependency("link", match[1], _strength(call, required=True), call, path)


def inside(call: Call) -> Iterator[tuple[str, int]]:
    """Yield the files of libraries below the source that a call names, each with its line."""
    if call.name in {"set", "target_link_libraries", "link_libraries"} and not call.in_function:
        found = (_INSIDE.match(word) for word in call.words[:MAX_LINKED] if word.startswith("$"))
        yield from ((match[1], call.line) for match in found if match)


def fetched(call: Call, path: str) -> Iterator[GitSource]:
    """Yield what a call fetches while CMake configures."""
    words = call.words
    values = dict(pairwise(words))
    url = values.get("GIT_REPOSITORY") or values.get("URL")
    if words and url and "${" not in url:
        ref = values.get("GIT_TAG")
        yield GitSource(
            name=values.get("NAME") or words[0],
            url=url,
            ref=ref if ref and "${" not in ref else None,
            strength="optional" if call.conditions else "declared",
            file=path,
            line=call.line,
            kind="fetch",
        )


def brought(call: Call) -> Iterator[str]:
    """Yield the names that what a call fetches, or makes, may have: its own, and the parts of the address."""
    if call.name == "add_library":
        yield from call.words[:1] if "IMPORTED" not in call.words else ()
        return
    keys = ("NAME", "PROJ", "GIT_REPOSITORY", "GITHUB_REPOSITORY", "GITLAB_REPOSITORY", "URL", "SOURCE_DIR")
    values = dict(pairwise(call.words))
    first = call.words[:1] if call.words[:1] != ("PROJ",) else ()
    for word in (*first, *(values.get(key, "") for key in keys)):
        yield from filter(None, _OF_ADDRESS.split(word))


def _found(call: Call, path: str, project: str | None) -> Iterator[Dependency]:
    if not call.words or "${" in call.words[0]:
        return
    finder = _finder(call.words[1:])
    required = "REQUIRED" in call.words or call.name == "find_dependency"
    strength = _strength(call, required=required, quiet="QUIET" in call.words)
    for name in call.words[0].split():  # a foreach over a list gives several
        if not _NAME.match(name) or name == project:
            continue
        if call.name in _OF_GAZEBO and not name.startswith(_LIBRARIES_OF_GAZEBO):
            continue
        if name in _ROS_FINDERS:
            for component in finder.components if name in _CATKIN else ():
                found = replace(_dependency("ros", component, strength, call, path), required=required)
                yield replace(found, namespace="cmake", role=COMPONENT) if _no_ros_package(component) else found
        else:
            yield replace(_dependency("cmake", name, strength, call, path, finder.version), required=required)
            for component in (*finder.components, *finder.optional):
                lesser = "optional" if component in finder.optional else strength
                for part in _apart(name, component):
                    yield _dependency("cmake", part, lesser, call, path)


def _no_ros_package(component: str) -> bool:
    """Tell whether a component of catkin is a library of its own, for which catkin calls ``find_package``: ``Torch``.

    No package of ROS has capital letters: https://www.ros.org/reps/rep-0144.html, read 2026-11-27.
    """
    return component != component.lower() and library("cmake", component, None) is not None


def _apart(name: str, component: str) -> tuple[str, ...]:
    """Return the name of a component that has packages of its own: ``DART utils``, ``Qt5SerialPort``, else nothing.

    ``find_package(Qt5 COMPONENTS SerialPort)`` calls ``find_package(Qt5SerialPort)``.
    """
    named = (f"{name} {component}", f"{name}{component}")
    return tuple(each for each in named if library("cmake", each, None) is not None)


def _finder(words: tuple[str, ...]) -> _Finder:
    """Sort the words after the name; catkin's components may have no keyword before them."""
    components: list[str] = []
    optional: list[str] = []
    version = None
    skipping = False
    into = components
    for word in words:
        if word in _FLAGS or word in {"COMPONENTS", "OPTIONAL_COMPONENTS"}:
            skipping = False
            into = optional if word == "OPTIONAL_COMPONENTS" else components
        elif word in _VALUED:
            skipping = True
        elif _VERSION.match(word) and not components:
            version = word
        elif not skipping and _NAME.match(word):
            into.append(word)
    return _Finder(components=tuple(components), optional=tuple(optional), version=version)


def of_no_build(condition: str) -> bool:
    """Tell whether a condition holds in no usual build on Linux: another system, an option that is off, tests."""
    return bool(_ELSEWHERE.match(condition) or condition.startswith("OFF ") or _TEST.search(condition))


def of_an_option(condition: str) -> bool:
    """Tell whether an option decides a condition, or whether it is about tests."""
    return bool(_SWITCH.match(condition) or _TEST.search(condition))


def made_here(conditions: tuple[str, ...]) -> bool:
    """Tell whether a call below these conditions is made in an image for certain."""
    return not any(_ELSEWHERE.match(condition) or not _HERE.match(condition) for condition in conditions)


def _strength(call: Call, *, required: bool, quiet: bool = False) -> Strength:
    """Return the strength of a call: required and unconditional is declared; conditional or quiet alone is optional."""
    if not made_here(call.conditions) or (quiet and not required):
        return "optional"
    return "declared" if required else "used"


def _dependency(  # noqa: PLR0917 - called in one file, in the order of its sentence
    namespace: Literal["cmake", "ros", "pkg-config", "link"],
    name: str,
    strength: Strength,
    call: Call,
    path: str,
    version: str | None = None,
) -> Dependency:
    condition = " AND ".join(call.conditions) or None
    test = bool(condition and _TEST.search(condition)) or places.test(path)
    return Dependency(
        namespace=namespace,
        name=name,
        strength=strength,
        file=path,
        line=call.line,
        version=version,
        role="test" if test else "build",
        condition=condition,
    )


def folders(call: Call) -> tuple[str, ...]:
    """Return the folders that a call adds: one, or those of CMake's older ``subdirs``.

    An ``include`` of another folder's CMakeLists.txt makes what that file makes, too.
    https://cmake.org/cmake/help/latest/command/subdirs.html, read 2026-11-26.
    """
    if call.name == "include":
        return tuple(word.removesuffix(_LISTS) for word in call.words[:1] if word.endswith(_LISTS))
    if call.name == "subdirs":
        return tuple(word for word in call.words if word not in {"PREORDER", "EXCLUDE_FROM_ALL"})
    return call.words[:1] if call.name == "add_subdirectory" else ()
