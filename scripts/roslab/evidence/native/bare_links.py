"""Libraries that CMake links by names which no file of the tree makes, finds or so much as names elsewhere."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.cmake import EVERY, calls
from roslab.evidence.native.searched import held
from roslab.knowledge.libraries import library
from roslab.knowledge.shared_objects import given
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_FILES = 400
MAX_SIZE = 256 * 1024
_PLAIN = pattern(r"[A-Za-z_]\w{2,}$")
_END = pattern(r"[.-]")
_LINKING = frozenset(
    {"target_link_libraries", "link_libraries", "set", "list", "set_target_properties", "message"}
    | {"catkin_package", "ament_export_libraries"}
)
"""Calls in which the name of a library makes, finds and orders none: the last two tell others what to link."""
_GTEST = ("gtest", "gmock")


def with_bare(projects: Iterable[CMakeProject], repository: Repository) -> list[CMakeProject]:
    """Return the projects with those libraries that each always links, in ``bare``."""
    found = list(projects)
    named = {project.file: [*_unknown(project, repository)] for project in found}
    names = {each.name for asked in named.values() for each in asked}
    if not names:
        return found
    names -= set(_elsewhere(names, repository))
    kept = {file: tuple(each for each in asked if each.name in names) for file, asked in named.items()}
    return [replace(project, bare=kept[project.file]) if kept[project.file] else project for project in found]


def _unknown(project: CMakeProject, repository: Repository) -> Iterator[Dependency]:
    """Yield what a project links by a name that no table has; the system's own libraries are none."""
    if places.aside(project.file):
        return
    for asked in project.dependencies:
        if asked.namespace != "link" or asked.strength != "used" or asked.role != "build":
            continue
        name = asked.name
        if _PLAIN.match(name) and not (_known(name) or given(f"lib{name}.so") or held(name, repository)):
            yield asked


def _known(name: str) -> bool:
    spelt = {name, name.lower(), name.removeprefix("lib")}
    return name.startswith(_GTEST) or any(
        library(naming, each, None) is not None for naming in ("link", "cmake", "pkg-config") for each in spelt
    )


def _elsewhere(names: set[str], repository: Repository) -> Iterator[str]:
    """Yield those of the names that other calls have: a function of the tree, or a file that is fetched, makes them."""
    files = (*repository.named("CMakeLists.txt"), *repository.suffixed(".cmake", ".in"))[:MAX_FILES]
    for file in files:
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        if not any(name in text for name in names):
            continue
        for call in calls(text, EVERY):
            if call.name not in _LINKING:
                for word in (part for each in (*call.words, *call.written) for part in each.replace("/", " ").split()):
                    plain = _END.split(word.removeprefix("lib"), maxsplit=1)[0]
                    yield from {word, plain} & names
