"""CMakeLists.txt: what is looked for, linked, fetched and built, and whether it must be there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from roslab.evidence import places
from roslab.evidence.cmake_text import Call, calls
from roslab.evidence.facts import CMakeProject, Dependency, GitSource, Strength
from roslab.repository import File, Repository

MAX_PROJECTS = 3_000
_NAMES = frozenset(
    {
        "project", "enable_language", "find_package", "find_dependency", "pkg_check_modules", "pkg_search_module", "add_executable", "add_library",
        "add_subdirectory", "target_link_libraries", "link_libraries", "fetchcontent_declare", "externalproject_add", "ament_target_dependencies",
        "catkin_package", "catkin_simple", "cs_*", "ament_*", "rosbuild_*", "rosidl_generate_interfaces", "cuda_add_executable", "cuda_add_library",
        "catkin_add_executable*", "add_message_files", "add_service_files", "generate_messages", "find_library", "autoware_package",
    }
)  # fmt: skip
_FIND_KEYWORDS = frozenset(
    {"REQUIRED", "QUIET", "EXACT", "CONFIG", "MODULE", "NO_MODULE", "NO_POLICY_SCOPE", "GLOBAL", "NO_DEFAULT_PATH", "NO_CMAKE_PATH", "BYPASS_PROVIDER"}
)
_FIND_VALUED = frozenset({"NAMES", "CONFIGS", "HINTS", "PATHS", "PATH_SUFFIXES", "REGISTRY_VIEW"})
_LINK_KEYWORDS = frozenset({"PUBLIC", "PRIVATE", "INTERFACE", "LINK_PUBLIC", "LINK_PRIVATE", "LINK_INTERFACE_LIBRARIES", "debug", "optimized", "general"})
_ROS_FINDERS = frozenset({"catkin", "catkin_simple", "ament_cmake", "ament_cmake_auto", "ament_cmake_ros", "ament_cmake_python", "rosidl_default_generators"})
_TEST = re.compile(r"CATKIN_ENABLE_TESTING|BUILD_TEST(?:S|ING)?|_TESTS?\b|GTEST", re.IGNORECASE)
_NAME = re.compile(r"^[A-Za-z][\w.+-]*$")
_LINK = re.compile(r"^(?:-l)?([A-Za-z_][\w.+-]*)$")
_CUDA = re.compile(r"^(?:CUDA|CUDAToolkit|CUDNN|TensorRT)$")
_VERSION = re.compile(r"^\d+(?:\.\d+)*$")
_MODULE = re.compile(r"^([A-Za-z][\w.+-]*?)(?:(?:>=|<=|=|>|<)[\d.]+)?$")


def read(repository: Repository) -> tuple[CMakeProject, ...]:
    """Return every CMakeLists.txt that says something, sorted by path; those of ``cmake/`` modules are not read."""
    files = sorted(repository.named("CMakeLists.txt"), key=lambda file: (file.path.count("/"), file.path))[:MAX_PROJECTS]
    added: set[str] = set()
    found: list[CMakeProject] = []
    for file in files:
        if repository.has(f"{file.folder}/.cmake") or "/CMakeFiles/" in file.path:
            continue
        found.append(_project(repository, file, added))
    known = tuple(sorted(found, key=lambda project: project.file))
    return tuple(project for project in known if project.name or project.dependencies or project.executables or project.macros)


def _project(repository: Repository, file: File, added: set[str]) -> CMakeProject:
    """Read one file; the folders that it adds are noted in ``added``."""
    name: str | None = None
    languages: list[str] = []
    macros: dict[str, None] = {}
    executables: dict[str, int] = {}
    libraries: set[str] = set()
    dependencies: list[Dependency] = []
    sources: list[GitSource] = []
    for call in calls(repository.read(file), _NAMES):
        words = call.words
        if call.name == "project" and words:
            name = name or words[0]
            languages += [word for word in words[1:] if word in {"C", "CXX", "CUDA", "Fortran"}]
        elif call.name == "enable_language":
            languages += words[:1]
        elif call.name == "add_subdirectory" and words:
            added.add(_joined(file.folder, words[0]))
        elif call.name in {"add_executable", "cuda_add_executable", "cs_add_executable", "rosbuild_add_executable", "ament_auto_add_executable"}:
            if words and _NAME.match(words[0]):
                executables.setdefault(words[0], call.line)
        elif call.name in {"add_library", "cuda_add_library", "cs_add_library", "ament_auto_add_library"}:
            libraries.update(words[:1])
        elif call.name in {"fetchcontent_declare", "externalproject_add"}:
            sources += _fetched(call, file)
        elif not call.in_function or call.name == "find_package":
            dependencies += _dependencies(call, file, name)
        _family(call, macros)
    if any(word == "CUDA" for word in languages):
        macros["cuda"] = None
    own = libraries | executables.keys() | {name}
    return CMakeProject(
        file=file.path,
        line=1,
        name=name,
        top_level=name is not None and file.folder not in added,
        languages=tuple(dict.fromkeys(languages)),
        macros=tuple(macros),
        executables=tuple(executables.items()),
        dependencies=tuple(dict.fromkeys(d for d in dependencies if d.namespace != "link" or d.name not in own)),
        sources=tuple(sources),
    )


def _joined(folder: str, path: str) -> str:
    path = path.replace("${CMAKE_CURRENT_SOURCE_DIR}/", "").replace("${PROJECT_SOURCE_DIR}/", "").removeprefix("./").rstrip("/")
    return f"{folder}/{path}" if folder else path


def _family(call: Call, macros: dict[str, None]) -> None:
    name, first = call.name, call.words[0] if call.words else ""
    if name.startswith("cuda_add"):
        macros["cuda"] = None
    elif name.startswith("rosbuild_"):
        macros["rosbuild"] = None
    elif (name.startswith("ament_") and name != "ament_target_dependencies") or name in {"autoware_package", "rosidl_generate_interfaces"}:
        macros["ament"] = None
    elif name in {"catkin_package", "catkin_simple"} or name.startswith("cs_"):
        macros["catkin"] = None
    if name == "find_package" and not call.conditions:
        if first in {"catkin", "catkin_simple"}:
            macros["catkin"] = None
        elif first.startswith("ament_"):
            macros["ament"] = None
        elif first == "autoware_cmake":
            macros["ament"] = None
        elif _CUDA.match(first) and "REQUIRED" in call.words:
            macros["cuda"] = None


def _dependencies(call: Call, file: File, project: str | None) -> Iterator[Dependency]:
    name, words = call.name, call.words
    if name in {"find_package", "find_dependency"} and words:
        yield from _found(call, file, project)
    elif name in {"pkg_check_modules", "pkg_search_module"}:
        strength = _strength(call, required="REQUIRED" in words)
        for word in words[1:]:
            match = _MODULE.match(word)
            if match and word not in {"REQUIRED", "QUIET", "IMPORTED_TARGET", "GLOBAL", "NO_CMAKE_PATH", "NO_CMAKE_ENVIRONMENT_PATH"}:
                yield _dependency("pkg-config", match[1], strength, call, file)
    elif name in {"target_link_libraries", "link_libraries", "find_library"}:
        for word in words[0 if name == "link_libraries" else 1 :][:60]:
            match = _LINK.match(word)
            if match and word not in _LINK_KEYWORDS and word.upper() != word:
                yield _dependency("link", match[1], "optional" if call.conditions or name == "find_library" else "used", call, file)


def _found(call: Call, file: File, project: str | None) -> Iterator[Dependency]:
    name, *rest = call.words
    components: list[str] = []
    version = None
    skipping = optional = False
    for word in rest:
        if word in _FIND_KEYWORDS:
            skipping = False
        elif word in _FIND_VALUED:
            skipping = True
        elif word in {"COMPONENTS", "OPTIONAL_COMPONENTS"}:
            skipping, optional = False, word != "COMPONENTS"
        elif _VERSION.match(word) and not components:
            version = word
        elif not skipping and not optional and _NAME.match(word):
            components.append(word)
    if "${" in name:
        return
    names = [name] if _NAME.match(name) else [part for part in name.split() if _NAME.match(part)]
    required = "REQUIRED" in rest or call.name == "find_dependency"
    for each in names:
        if each == project:
            continue
        strength = _strength(call, required=required, quiet="QUIET" in rest)
        if each in _ROS_FINDERS:
            for component in components:
                yield _dependency("ros", component, strength, call, file)
        else:
            yield _dependency("cmake", each, strength, call, file, tuple(components), version)


def _strength(call: Call, *, required: bool, quiet: bool = False) -> Strength:
    """Required and unconditional is declared; asked for quietly or behind a condition is optional."""
    conditions = [condition for condition in call.conditions if not re.match(r"^(?:NOT )?\(?(?:WIN32|MSVC|APPLE|UNIX)", condition) or "NOT (UNIX" in condition]
    if any(re.match(r"^(?:WIN32|MSVC|APPLE)\b", condition) for condition in call.conditions):
        return "optional"
    if conditions or quiet:
        return "optional"
    return "declared" if required else "used"


def _dependency(
    namespace: Literal["cmake", "ros", "pkg-config", "link"],
    name: str,
    strength: Strength,
    call: Call,
    file: File,
    components: tuple[str, ...] = (),
    version: str | None = None,
) -> Dependency:
    condition = " AND ".join(call.conditions) or None
    test = bool(condition and _TEST.search(condition)) or places.test(file.path)
    return Dependency(
        namespace=namespace,
        name=name,
        strength=strength,
        file=file.path,
        line=call.line,
        components=components,
        version=version,
        role="test" if test else "build",
        condition=condition,
    )


def _fetched(call: Call, file: File) -> Iterator[GitSource]:
    words = call.words
    values = {word: words[index + 1] for index, word in enumerate(words[:-1]) if word in {"GIT_REPOSITORY", "GIT_TAG", "URL"}}
    url = values.get("GIT_REPOSITORY") or values.get("URL")
    if words and url and "${" not in url:
        ref = values.get("GIT_TAG")
        yield GitSource(
            name=words[0],
            url=url,
            ref=ref if ref and "${" not in ref else None,
            strength="optional" if call.conditions else "declared",
            file=file.path,
            line=call.line,
            kind="fetch",
        )
