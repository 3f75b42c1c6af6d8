"""Packages that link a library of the tree by its file, which is not there and nothing makes: they do not link."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import BuildTool
from roslab.decide.decision import Warning_
from roslab.decide.programs import configured_by
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import Packages
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place


def lost_libraries(evidence: Evidence, packages: Packages, build_tool: BuildTool) -> Iterator[tuple[str, Warning_]]:
    """Yield the CMakeLists.txt of each such package, with a warning; no file where a submodule may bring it."""
    folders = {m.file.rpartition("/")[0]: m.name for m in packages.built if m.name}
    made = {name for project in evidence.cmake for name in project.made}
    submodules = [source.name for source in evidence.sources if source.kind == "submodule"]
    for project in evidence.cmake:
        package = configured_by(project, folders)
        if package is None or not project.lost or places.aside(project.file):
            continue
        paths = [
            (path, line)
            for path, line in project.lost
            if path.rpartition("/")[2].rpartition(".")[0].removeprefix("lib") not in made
        ]
        if not paths:
            continue
        names = ", ".join(path for path, _ in paths)
        held = [each for each in submodules if any(path.startswith(f"{each}/") for path, _ in paths)]
        lacks = "may not have" if held else "does not have"
        perhaps = f" ({' and '.join(held)}: a submodule without package.xml is not compiled)" if held else ""
        what = f"{package} links {names}, which the repository {lacks} and its build does not make{perhaps}"
        stops = f"where it is not there, {build_tool} stops" if held else f"{build_tool} will most likely stop there"
        then = "compile it there first under `custom` in roslab.yaml, or add it"
        yield "" if held else project.file, warn(f"{what}: {stops}; {then}", _place(project.file, paths))


def _place(file: str, paths: list[tuple[str, int]]) -> Place:
    return Place(file=file, line=paths[0][1])
