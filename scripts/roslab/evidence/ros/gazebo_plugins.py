"""The plugins of Gazebo that robots, worlds and launch files load, which few package.xml name."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.lines import matches_at
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 800
"""Most files that are opened, those nearest to the root first."""
MAX_PAGES = 60
"""Most pages that are opened."""
_LIBRARY = pattern(r"lib[\w-]{1,80}\.so\b(?!\.)")
_BARE = pattern(r"filename\s{0,9}=\s{0,9}[\"']([\w-]{1,80})[\"']")
"""As today's Gazebo finds it: ``gz_ros2_control-system`` is libgz_ros2_control-system.so."""

_FOUND = pattern(r"\$\(find[ ]([a-z0-9]\w{0,40}_description)\)")
_ROBOTS = (".xacro", ".urdf", ".gazebo")
"""Descriptions of robots, which name plugins for whoever simulates them."""
_BUILD = ("package.xml", "CMakeLists.txt", "Dockerfile")
_SIMULATES = pattern(r"gazebo|ignition|(?<![a-z])gz(?![a-z])|simulat|spawn", re.IGNORECASE)


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of the libraries that are loaded, each once, where it is loaded first.

    None of those that descriptions of robots name where nothing else of the tree speaks of a simulation; so it is with
    what robots and sensors of other packages load that the tree finds there.
    """
    descriptions = repository.suffixed(".xacro", ".urdf", ".sdf", ".world", ".gazebo", ".launch")
    launching = (file for file in repository.suffixed(".py") if "launch" in file.name)
    files = [file for file in (*descriptions, *launching) if file.size <= MAX_SIZE and not places.vendored(file.path)]
    found: dict[str, Dependency] = {}
    elsewhere: dict[str, Dependency] = {}
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for package, line in _of_others(text):
            loaded = Dependency(namespace="ros", name=package, strength="used", file=file.path, line=line, role="exec")
            elsewhere.setdefault(package, loaded)
        loads = ".so" in text or "filename" in text
        text = without_xml_comments(text) if loads else ""
        named = [(match.start(), match[0]) for match in matches_at(_LIBRARY, text, "lib")]
        named += [(match.start(), f"lib{match[1]}.so") for match in matches_at(_BARE, text, "filename")]
        for start, library in sorted(named):
            from roslab.knowledge.gazebo_plugins import gazebo_plugins  # noqa: PLC0415 - few trees load a library by its file

            if (plugin := gazebo_plugins().get(library)) and plugin not in found:
                line = text.count("\n", 0, start) + 1
                found[plugin] = Dependency(
                    namespace="ros", name=plugin, strength="used", file=file.path, line=line, role="exec"
                )
    elsewhere = {name: each for name, each in elsewhere.items() if name not in found}
    unsure = not found or all(each.file.endswith(_ROBOTS) for each in found.values())
    if unsure and (found or elsewhere) and not _simulates(repository):
        return ()
    return (*found.values(), *elsewhere.values())


def _of_others(text: str) -> Iterator[tuple[str, int]]:
    """Yield the packages that descriptions of other packages load, each with the line in which these are found."""
    if "_description)" not in text:
        return
    from roslab.knowledge.described_plugins import described_plugins  # noqa: PLC0415 - few trees find one

    text = without_xml_comments(text)
    for match in _FOUND.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        yield from ((name, line) for name in described_plugins().get(match[1], ()))


def _simulates(repository: Repository) -> bool:
    """Tell whether there is a world, or what starts, builds or explains the tree speaks of a simulation."""
    if repository.suffixed(".world", ".sdf"):
        return True
    launching = (file for file in repository.suffixed(".launch", ".py", ".xml", ".yaml") if "launch" in file.name)
    building = (file for name in _BUILD for file in repository.named(name))
    files = (*launching, *building, *repository.suffixed(".repos", ".rosinstall", ".sh"))
    written = (*repository.suffixed(".md", ".rst"), *repository.named("README"), *repository.named("README.txt"))
    written = tuple(file for file in written if file.size <= MAX_SIZE and not file.name.upper().startswith("CHANGE"))
    files = (*nearest(written)[:MAX_PAGES], *nearest(files)[:MAX_FILES])
    return any(_SIMULATES.search(repository.read(file)) for file in files if not places.vendored(file.path))
