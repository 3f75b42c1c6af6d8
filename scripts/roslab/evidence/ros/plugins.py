"""The packages that parameter files, robot descriptions and saved layouts name: those of plugins, mostly."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.evidence.ros import launch, perspectives, plugin_types
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.dataclass import replace


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages that parameter files, robot descriptions and layouts of rqt name, and rviz for its files.

    What a named plugin loads by short names or by default is one of them.
    """
    found: dict[str, Dependency] = {}
    files = [
        f
        for f in repository.suffixed(".yaml", ".yml", ".xacro", ".urdf", ".sdf")
        if f.size < launch.MAX_SIZE and not places.vendored(f.path)
    ]
    for file in nearest(files)[: launch.MAX_FILES]:
        text = repository.read(file)
        for dependency in _described(text, file):
            found.setdefault(dependency.name, dependency)
    for dependency in tuple(found.values()):
        from roslab.knowledge.plugin_companions import plugin_companions  # noqa: PLC0415 - few trees name plugins

        for name in plugin_companions().get(dependency.name, ()):
            found.setdefault(name, replace(dependency, name=name))
    found = {**{each.name: each for each in perspectives.read(repository)}, **found}
    for file in repository.suffixed(".rviz")[:1]:
        name = "rviz2" if "rviz_common/" in repository.read(file) else "rviz"
        viewer = Dependency(namespace="ros", name=name, strength="used", file=file.path, line=1, role="exec")
        found.setdefault(name, viewer)
    return tuple(found.values())


def _described(text: str, file: File) -> Iterator[Dependency]:
    """Yield the packages of the plugins of a parameter file, or those in which a robot description finds files."""
    if not file.name.endswith(("yaml", "yml")):
        yield from launch.matches(without_xml_comments(text), file, (launch.FIND,))
        return
    for name, place in plugin_types.named(text):
        line = text.count("\n", 0, place) + 1
        yield Dependency(namespace="ros", name=name, strength="used", file=file.path, line=line, role="exec")
