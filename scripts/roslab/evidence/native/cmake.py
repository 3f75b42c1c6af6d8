"""CMakeLists.txt: what it looks for, links, fetches and builds, and what is required."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.hidden import hidden
from roslab.evidence.lex.cmake import FROM_HERE, PROJECT, WHOLE, Call, calls
from roslab.evidence.native import (
    cmake_needs,
    cmake_since,
    fetching_macros,
    imported_targets,
    included,
    installed_programs,
    linker_flags,
    own_project,
)
from roslab.evidence.native.absent_folders import absent_folders
from roslab.evidence.native.added import Added
from roslab.evidence.native.authors_parts import authors_parts
from roslab.evidence.native.bare_links import with_bare
from roslab.evidence.native.cmake_reading import Reading
from roslab.evidence.native.find_modules import by_module, goes_on
from roslab.evidence.native.installed_paths import code_not_there, installed, not_there
from roslab.evidence.native.lost_libraries import lost, named
from roslab.evidence.native.macros import macros
from roslab.evidence.native.made_below import without_made
from roslab.evidence.native.made_targets import TARGET, target
from roslab.evidence.native.optional_cuda import brings
from roslab.evidence.native.outside import of_workspace
from roslab.evidence.native.own_configs import configs
from roslab.evidence.native.program_folders import VARIABLES
from roslab.evidence.native.searched import held, searched
from roslab.evidence.native.searched_programs import searched_programs
from roslab.evidence.native.settled import settled
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_PROJECTS = 3_000
MAX_MODULE = 64 * 1024
_EXECUTABLE = frozenset(
    [
        *("add_executable", "cuda_add_executable", "cs_add_executable"),
        *("rosbuild_add_executable", "ament_auto_add_executable"),
    ]
)
_LIBRARY = frozenset(
    [
        *("add_library", "cuda_add_library", "cs_add_library", "ament_auto_add_library", "generate_parameter_library"),
        *("pybind11_add_module", "nanobind_add_module", "python_add_library", "python3_add_library"),
    ]
)
"""What makes a library; ``generate_parameter_library`` a header of its name from YAML, the last ones those of Python.

https://github.com/PickNikRobotics/generate_parameter_library/blob/main/generate_parameter_library/cmake/generate_parameter_library.cmake
(read 2026-11-26)
"""
_TARGETS = _EXECUTABLE | _LIBRARY
_COMPONENT = "rclcpp_components_register_node"
_REPEATED = _TARGETS | {"set_target_properties", _COMPONENT}
_TESTS = frozenset({"add_test", "gtest_discover_tests", "catch_discover_tests"})
_NOTING = {
    **dict.fromkeys(_TESTS, Reading.test),
    **dict.fromkeys(_LIBRARY, Reading.library),
    _COMPONENT: Reading.component,
}
_NAMES = (
    cmake_needs.CALLS
    | _TESTS
    | cmake_needs.BRINGING
    | _EXECUTABLE
    | _LIBRARY
    | {_COMPONENT}
    | frozenset(
        [
            "project",
            "cmake_minimum_required",
            "enable_language",
            "add_subdirectory",
            "subdirs",
            "include",
            "set",
            "set_target_properties",
            "catkin_package",
            "install",
            "catkin_simple",
            "autoware_package",
        ]
    )
    | {"cs_*", "ament_*", "rosbuild_*", "rosidl_generate_interfaces"}
)
_LANGUAGES = frozenset({"C", "CXX", "CUDA", "Fortran"})
_MODULE = pattern(r"^(?:Find([\w.+-]+)|([\w.+-]+?)-?[cC]onfig)\.cmake(?:\.in)?$")


def read(repository: Repository) -> tuple[CMakeProject, ...]:
    """Return every CMakeLists.txt with anything of interest, sorted by path; build folders are skipped."""
    files = nearest(repository.named("CMakeLists.txt"))
    added: dict[str, Added] = {}
    found = [_project(repository, file, added) for file in files[:MAX_PROJECTS] if "/CMakeFiles/" not in file.path]
    kept = (
        p
        for p in found
        if p.name
        or p.top_level
        or p.dependencies
        or p.executables
        or p.macros
        or p.linked
        or p.newer
        or p.programs
        or (p.added and p.made)
    )
    own = with_bare(without_made(cmake_since.without_own(kept, repository, modules(repository))), repository)
    return tuple(sorted(own, key=lambda each: each.file))


def modules(repository: Repository) -> frozenset[str]:
    """Return the names that a file of the tree finds for CMake: ``FindNAME.cmake``, ``NAMEConfig.cmake``."""
    found = (_MODULE.match(file.name) for file in repository.suffixed(".cmake", ".in"))
    return frozenset(match[1] or match[2] for match in found if match)


def _project(repository: Repository, file: File, added: dict[str, Added]) -> CMakeProject:
    """Read one file; the folders that it adds go into ``added``, so parents must be read first."""
    above = added.get(file.folder, Added())
    reading = Reading(switches=above.switches, by_tool=above.by_tool, unset=above.unset)
    adds: list[str] = []
    options = dict(above.options)
    text = repository.read(file)
    for call in calls(text, fetching_macros.names(text, _NAMES | cmake_since.names()), options, _REPEATED, above.names):
        cmake_since.note(call, file.path, reading.newer)
        if folders := cmake_needs.folders(call):
            adds += (here := [_joined(file.folder, folder) for folder in folders])
            switches = tuple(filter(cmake_needs.of_an_option, (*above.switches, *call.conditions)))
            within = above.within or not places.test(file.path)
            always = (above.always or file.folder not in added) and not (call.conditions or call.in_function)
            usual = above.usual and not call.in_function and cmake_needs.made_here(call.conditions)
            by_tool = (*above.by_tool, *filter(of_workspace, call.conditions))
            top = file.folder if above.top is None else above.top
            there = Added(
                options=dict(options),
                names=_names(reading.name, above),
                switches=switches,
                by_tool=by_tool,
                unset=(*above.unset, *filter(str.isidentifier, call.conditions)),
                within=within,
                top=top,
                always=always,
                usual=usual,
            )
            added |= dict.fromkeys(here, there) | added
        elif call.name == "include":
            _include(call, repository, file, reading)
            if reading.name is None and (by_macro := own_project.wrapped(call, file.path, text, repository)):
                reading.name = by_macro[0]
                reading.dependencies.append(by_macro[1])
            for needing, path in included.needing(call, repository, file, reading.included, options):
                if needing.name == "cmake_minimum_required":
                    cmake_since.raised(needing, path, reading.newer)
                    continue
                if needing.in_function:
                    reading.brought |= dict.fromkeys(cmake_needs.brought(needing))
                    continue
                cmake_since.note(needing, path, reading.newer)
                _note(needing, path, reading)
                reading.dependencies += by_module(needing, repository, file, reading.modules, included=True)
        elif not goes_on(call, text, repository, file):
            _note(call, file.path, reading)
            reading.dependencies += by_module(call, repository, file, reading.modules)
    reading.dependencies = [cmake_needs.of_lua(asked, text) for asked in reading.dependencies]
    reading.dependencies += searched(text, file.path, repository)
    own = reading.libraries | reading.executables.keys() | {reading.name}
    by_itself = own - (reading.libraries - reading.made.keys())  # a target may be no more than the file of a library
    always = above.always or file.folder not in added
    lacking = reading.lacking(text, file.folder, repository) if always else ()
    return CMakeProject(
        file=file.path,
        line=1,
        name=reading.name,
        top_level=file.folder not in added
        and own_project.stands_alone(
            reading.name,
            makes=bool((adds and not file.folder) or reading.executables or reading.libraries),
            minimum=reading.minimum is not None,
            rosbuild="rosbuild" in reading.macros,
        ),
        ignored=hidden(repository, file.folder),
        added=above.within,
        adds=tuple(adds),
        top=file.folder if above.top is None else above.top,
        always=above.always,
        usual=above.usual,
        languages=tuple(dict.fromkeys(reading.languages)),
        macros=tuple(name for name in reading.macros if name != "cuda" or brings(reading.cuda, options, repository)),
        cuda=any(not call.conditions for call in reading.cuda),
        executables=tuple((reading.written.file(name), line) for name, line in reading.executables.items()),
        dependencies=tuple(
            dict.fromkeys(
                d
                for d in reading.dependencies
                if d.namespace != "link"
                or not (d.name in (by_itself if d.strength == "declared" else own) or held(d.name, repository))
            )
        ),
        programs=tuple(searched_programs(text, file.path, repository)),
        sources=tuple(reading.sources),
        brought=tuple(reading.brought),
        minimum=reading.minimum,
        newer=tuple(reading.newer.values()),
        tests=reading.tests,
        untested=reading.untested,
        programs_in=reading.written.folder,
        placed=tuple(reading.written.elsewhere()),
        in_bin=tuple(map(reading.written.file, installed_programs.in_bin(reading.placed, reading.executables))),
        made=tuple(reading.made),
        installs=tuple(name for name in reading.made if name in reading.placed),
        targets=tuple(reading.targets) if always else (),
        not_there=not_there(reading.installed, text, repository) if always else (),
        configs=tuple(reading.configs),
        linked=tuple((path, line) for path, line in reading.linked.items() if not repository.has(path)),
        lost=lost(reading.files, file.folder, text, repository) if always else (),
        guards=tuple((reading.written.file(name), package) for name, package in reading.guards),
        outside=tuple((reading.written.file(name), ros) for name, ros in reading.outside),
        without_options=reading.without_options(),
        optional=tuple((reading.written.file(name), variable) for name, variable in reading.optional),
        settled=settled((variable.removeprefix("OFF ") for _, variable in reading.optional), repository),
        lacks=_lacks(repository, file.folder, reading),
        parts=tuple(authors_parts(text, repository)) if always else (),
        absent=tuple(absent_folders(text, file.path, repository)) if always else (),
        without=code_not_there(reading.always, text, file.folder, repository) if always else (),
        lacking=lacking,
    )


def _names(project: str | None, above: Added) -> Mapping[str, tuple[str, ...]]:
    """Return the variables with the names of a project and of the whole for the folders that it adds."""
    return {WHOLE: (project,), **above.names, PROJECT: (project,)} if project else above.names


def _include(call: Call, repository: Repository, file: File, reading: Reading) -> None:
    """Note the folder that a file of the tree, which is included, gives programs."""
    written = call.words[0] if call.words else ""
    name = written.rpartition("/")[2].removesuffix(".cmake")
    if not TARGET.match(name) or (written == name and name.startswith(included.OF_CMAKE)):
        return
    for module in repository.named(f"{name}.cmake")[:1]:
        text = repository.read(module) if module.size <= MAX_MODULE else ""
        for inner in calls(text, frozenset({"set"})) if any(word in text for word in VARIABLES) else ():
            reading.written.note(inner, file.folder, reading.executables)


def _note(call: Call, path: str, reading: Reading) -> None:
    name, words = call.name, call.words
    told = replace(call, conditions=(*reading.switches, *call.conditions)) if reading.switches else call
    reading.targets |= target(call) if name in _TARGETS else {}
    reading.installed += installed(call, path.rpartition("/")[0], own=bool(reading.name) or "/" not in path)
    reading.configs |= configs(call)
    for target_name, folder in installed_programs.placed(call):
        reading.placed.setdefault(target_name, set()).add(folder)
    if name == "project" and words and not any(each.startswith("OFF ") for each in call.conditions):
        reading.name = reading.name or words[0]
        reading.languages += [word for word in words[1:] if word in _LANGUAGES]
    elif name in {"set", "set_target_properties"}:
        reading.written.note(call, path.rpartition("/")[0], reading.executables)
        reading.dependencies += (*cmake_needs.files(told, path), *linker_flags.named(told, path))
    elif name == "cmake_minimum_required":
        reading.minimum = reading.minimum or cmake_since.minimum(call, path)
        cmake_since.raised(call, path, reading.newer)
    elif name == "enable_language":
        reading.languages += words[:1]
    elif name in _EXECUTABLE and words and TARGET.match(words[0]):
        reading.program(told)
    elif noting := _NOTING.get(name):
        noting(reading, told)
    elif name in cmake_needs.BRINGING or fetching_macros.fetches(call):
        reading.brought |= dict.fromkeys(cmake_needs.brought(call))
        reading.sources += cmake_needs.fetched(told, path) if name in cmake_needs.FETCHING or name not in _NAMES else ()
    elif name in cmake_needs.CALLS and (not call.in_function or name == "find_package"):
        reading.dependencies += cmake_needs.needs(told, path, reading.name)
        reading.dependencies += imported_targets.needs(told, path)
    reading.linked |= {path: line for path, line in cmake_needs.inside(call) if path not in reading.linked}
    reading.files |= dict(named(call, path.rpartition("/")[0], own=reading.name is not None))
    reading.macros |= (families := macros(call))
    reading.cuda += [told] if "cuda" in families else []


def _lacks(repository: Repository, folder: str, reading: Reading) -> bool:
    code = reading.named or reading.compiled  # where no program names files, those of libraries
    return bool(code) and not any(repository.has(_joined(folder, name)) for name in code)


def _joined(folder: str, path: str) -> str:
    path = FROM_HERE.sub("", path).rstrip("/")
    return f"{folder}/{path}" if folder else path
